using System.Runtime.CompilerServices;

namespace LabRaytracer;

/// <summary>A checkerboard (Polish: szachownica) of two colours, in texture space or through the object's volume.</summary>
/// <remarks>
/// <para>Texture space: (floor(n_u u) + floor(n_v v)) mod 2 chooses the colour. Volume: (floor(n_u x) + floor(n_v y) + floor(n_u z)) mod 2.
/// A surface that lies exactly on a cell boundary takes the cell its normal points away from, so a floor at y = 0 does not flicker.</para>
/// <para>Lines, if any, are drawn where a texture-space cell's fractional part is below half of the line width or above one minus that.</para>
/// <para>With <see cref="PatternFilter.Area"/> the colour is the mean over the footprint: products of exact means of square waves, see there.</para>
/// <para>Immutable, thread safe.</para>
/// </remarks>
public sealed class CheckerTexture : IPreparedTexture
{
    private readonly double _columns = 8;
    private readonly double _rows = 8;
    private readonly double _lineWidth;

    /// <summary>Colour of the cells whose numbers add up to an even number. Default: white.</summary>
    public Intensity Even { get; init; } = Intensity.White;

    /// <summary>Colour of the other cells. Default: black.</summary>
    public Intensity Odd { get; init; } = Intensity.Black;

    /// <summary>Cells along u from 0 to 1, or along x and z in one local unit; above 0, finite. Default: 8.</summary>
    /// <exception cref="ArgumentOutOfRangeException">Not a finite number above 0.</exception>
    public double Columns
    {
        get => _columns;
        init => _columns = Positive(value);
    }

    /// <summary>Cells along v from 0 to 1, or along y in one local unit; above 0, finite. Default: 8.</summary>
    /// <exception cref="ArgumentOutOfRangeException">Not a finite number above 0.</exception>
    public double Rows
    {
        get => _rows;
        init => _rows = Positive(value);
    }

    /// <summary>Where the cells lie. Default: texture space.</summary>
    public CheckerSpace Space { get; init => field = PropertyChecks.Known(value); }

    /// <summary>Width of lines between the cells of texture space, cells, [0, 1]. Default: 0, none.</summary>
    /// <exception cref="ArgumentOutOfRangeException">Outside [0, 1] or NaN.</exception>
    public double LineWidth
    {
        get => _lineWidth;
        init => _lineWidth = value is >= 0 and <= 1
            ? value
            : throw new ArgumentOutOfRangeException(nameof(value), value, "The line width of a checker must be in [0, 1] cells.");
    }

    /// <summary>Colour of the lines. Default: black.</summary>
    public Intensity Line { get; init; } = Intensity.Black;

    /// <summary>Whether colours are those of points or means over what samples cover. Default: nearest, points.</summary>
    public PatternFilter Filter { get; init => field = PropertyChecks.Known(value); }

    /// <inheritdoc/>
    public TextureNeeds Needs =>
        (Space == CheckerSpace.Uv ? TextureNeeds.Coordinate : TextureNeeds.LocalPoint) | (Filter == PatternFilter.Area ? TextureNeeds.Footprint : TextureNeeds.None);

    /// <inheritdoc/>
    public Intensity Sample(in TextureLookup lookup)
    {
        if (Filter == PatternFilter.Area)
        {
            return CheckerAreaSampler.Sample(this, lookup);
        }

        if (Space == CheckerSpace.Uv)
        {
            Double1 u = new(lookup.Coordinate.U * Columns), v = new(lookup.Coordinate.V * Rows);
            return Double1.Any(OnLine(u) | OnLine(v)) ? Line : Double1.Any(IsOdd(Double1.Floor(u) + Double1.Floor(v))) ? Odd : Even;
        }

        Double1 sum = Cell(new Double1(lookup.LocalPoint.X), Columns, new Double1(lookup.LocalNormal.X))
            + Cell(new Double1(lookup.LocalPoint.Y), Rows, new Double1(lookup.LocalNormal.Y))
            + Cell(new Double1(lookup.LocalPoint.Z), Columns, new Double1(lookup.LocalNormal.Z));
        return Double1.Any(IsOdd(sum)) ? Odd : Even;
    }

    TextureNeeds IPreparedTexture.NeedsUnder(TextureFilter? filter) => filter == TextureFilter.Nearest ? Needs & ~TextureNeeds.Footprint : Needs;

    TextureSampler IPreparedTexture.Prepare(TextureUse use, TextureFilter? filter) =>
        Filter == PatternFilter.Area && filter != TextureFilter.Nearest ? new CheckerAreaSampler(this) : new Sampler(this);

    /// <summary>Number of the cell along one axis of the volume; a point exactly on a boundary belongs to the side its normal points away from.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    internal static R Cell<R>(R coordinate, double cells, R normal)
        where R : unmanaged, IReal<R>
    {
        R scaled = coordinate * R.Of(cells);
        R cell = R.Floor(scaled);
        R below = R.Equal(scaled, cell) & R.Less(R.Zero, normal);
        return R.Select(below, cell - R.Of(1), cell);
    }

    /// <summary>Mask of odd integers.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static R IsOdd<R>(R integer)
        where R : unmanaged, IReal<R>
    {
        R half = integer * R.Of(0.5);
        return R.Less(R.Floor(half), half);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private R OnLine<R>(R scaled)
        where R : unmanaged, IReal<R>
    {
        R fraction = scaled - R.Floor(scaled);
        R half = R.Of(_lineWidth / 2);
        return R.Less(fraction, half) | R.Less(R.Of(1) - half, fraction);
    }

    private static double Positive(double value) => value > 0 && double.IsFinite(value)
        ? value
        : throw new ArgumentOutOfRangeException(nameof(value), value, "The number of cells must be finite and above 0.");

    /// <summary>The checker, many points at a time.</summary>
    private sealed unsafe class Sampler(CheckerTexture checker) : TextureSampler
    {
        public override void Sample<R, F, I>(in LookupBatch<R> lookups, in ColorColumns<F> colors, int packets)
        {
            for (int packet = 0; packet < packets; packet++)
            {
                R line = R.Zero;
                R sum;
                if (checker.Space == CheckerSpace.Uv)
                {
                    R u = lookups.Coordinates.U[packet] * R.Of(checker.Columns), v = lookups.Coordinates.V[packet] * R.Of(checker.Rows);
                    sum = R.Floor(u) + R.Floor(v);
                    line = checker.OnLine(u) | checker.OnLine(v);
                }
                else
                {
                    PositionBatch<R> at = lookups.Positions;
                    sum = Cell(at.X[packet], checker.Columns, at.NormalX[packet])
                        + Cell(at.Y[packet], checker.Rows, at.NormalY[packet])
                        + Cell(at.Z[packet], checker.Columns, at.NormalZ[packet]);
                }

                F odd = R.MaskToSingle(IsOdd(sum)), onLine = R.MaskToSingle(line);
                colors.R[packet] = Choose(odd, onLine, checker.Odd.R, checker.Even.R, checker.Line.R);
                colors.G[packet] = Choose(odd, onLine, checker.Odd.G, checker.Even.G, checker.Line.G);
                colors.B[packet] = Choose(odd, onLine, checker.Odd.B, checker.Even.B, checker.Line.B);
            }
        }

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        private static F Choose<F>(F isOdd, F isLine, float odd, float even, float line)
            where F : unmanaged, IReal<F> => F.Select(isLine, F.Of(line), F.Select(isOdd, F.Of(odd), F.Of(even)));
    }
}
