using System.Runtime.CompilerServices;

namespace LabRaytracer;

/// <summary>A brick wall (Polish: mur z cegieł) in texture space: rows of bricks, every second row shifted, mortar in between.</summary>
/// <remarks>
/// <para>Row j = floor(rows v); brick i = floor(columns u + shift (j mod 2)). Inside a brick, a point less than half the mortar's width from an edge is mortar. The mortar is as wide
/// along u as along v where (u, v) have the same scale: <see cref="Mortar"/> / rows texture units.</para>
/// <para>Filtered: the share of brick is the box integral along v times that along u, exact for one row and in the mean of many. Bricks repeat with u over whole
/// numbers, so that a wall closes around a cylinder if the number of columns is whole (and that of rows even, where v closes too).</para>
/// <para>Immutable, thread safe.</para>
/// </remarks>
public sealed class BrickTexture : IPreparedTexture
{
    private readonly double _columns = 8;
    private readonly double _rows = 16;

    /// <summary>Colour of the bricks, linear. Default: brick red.</summary>
    public Intensity Brick { get; init; } = new(0.42f, 0.11f, 0.06f);

    /// <summary>Colour of the mortar, linear. Default: light grey.</summary>
    public Intensity MortarColor { get; init; } = new(0.55f, 0.53f, 0.5f);

    /// <summary>Bricks along u from 0 to 1; above 0, finite. Default: 8.</summary>
    /// <exception cref="ArgumentOutOfRangeException">Not a finite number above 0.</exception>
    public double Columns
    {
        get => _columns;
        init => _columns = PropertyChecks.Positive(value, "number of columns of a brick wall");
    }

    /// <summary>Rows along v from 0 to 1; above 0, finite. Default: 16.</summary>
    /// <exception cref="ArgumentOutOfRangeException">Not a finite number above 0.</exception>
    public double Rows
    {
        get => _rows;
        init => _rows = PropertyChecks.Positive(value, "number of rows of a brick wall");
    }

    /// <summary>Width of the mortar as a share of a row's height, [0, 1]. Default: 0.12.</summary>
    /// <exception cref="ArgumentOutOfRangeException">Outside [0, 1] or NaN.</exception>
    public double Mortar { get; init => field = PropertyChecks.Share(value, "mortar of a brick wall"); } = 0.12;

    /// <summary>How far every second row is shifted, in bricks, [0, 1]. Default: 0.5.</summary>
    /// <exception cref="ArgumentOutOfRangeException">Outside [0, 1] or NaN.</exception>
    public double Shift { get; init => field = PropertyChecks.Share(value, "shift of a brick wall"); } = 0.5;

    /// <summary>How much darker than <see cref="Brick"/> a brick may be, at random, [0, 1]. Default: 0, all alike.</summary>
    /// <exception cref="ArgumentOutOfRangeException">Outside [0, 1] or NaN.</exception>
    public double Variation { get; init => field = PropertyChecks.Share(value, "variation of a brick wall"); }

    /// <summary>Chooses one of many variations; any number. Default: 0.</summary>
    public int Seed { get; init; }

    /// <summary>Width of the filter in footprints of the sample, [0, 16]; 0: none, and rays need not know their footprints. Default: 1.</summary>
    /// <exception cref="ArgumentOutOfRangeException">Outside [0, 16] or NaN.</exception>
    public double FilterWidth { get; init => field = PropertyChecks.FilterWidth(value); } = 1;

    /// <inheritdoc/>
    public TextureNeeds Needs => PatternSampler.Needs(PatternSpace.Uv, FilterWidth);

    /// <inheritdoc/>
    public Intensity Sample(in TextureLookup lookup)
    {
        Float1 width = FilterWidth > 0 ? FootprintWidth.Of(lookup, PatternSpace.Uv) * Float1.Of(FilterWidth) : Float1.Zero;
        Parts<Double1, Float1, Int1>(new(lookup.Coordinate.U), new(lookup.Coordinate.V), width, out Float1 share, out Float1 light);
        Colors(share, light, out Float1 red, out Float1 green, out Float1 blue);
        return new Intensity(red.Value, green.Value, blue.Value);
    }

    TextureSampler IPreparedTexture.Prepare(TextureUse use, TextureFilter? filter) => new Sampler(this);

    /// <summary>The share of brick, and the brightness of the brick.</summary>
    [MethodImpl(MethodImplOptions.NoInlining)]
    private void Parts<R, F, I>(R u, R v, F width, out F share, out F light)
        where R : unmanaged, ILane<R, F, I>
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I>
    {
        R row = v * R.Of(Rows), rowNumber = R.Floor(row), half = rowNumber * R.Of(0.5);
        R isOdd = R.Less(R.Floor(half), half);
        R brick = R.Fma(u, R.Of(Columns), isOdd & R.Of(Shift));
        double mortarAcross = Math.Min(1, Mortar * Columns / Rows);
        F across = Covered<R, F, I>(brick, R.FromSingle(width * F.Of(Columns)), mortarAcross);
        F up = Covered<R, F, I>(row, R.FromSingle(width * F.Of(Rows)), Mortar);
        share = across * up;
        light = F.Of(1);
        if (Variation > 0)
        {
            // Bricks are counted around, so that a wall closes.
            R turn = R.Of(Math.Max(1, Math.Round(Columns)));
            R number = R.Floor(brick);
            number -= turn * R.Floor(number / turn);
            I cellX = Lattice.Cell<R, F, I>(number, out _), cellY = Lattice.Cell<R, F, I>(rowNumber, out _);
            I bits = CellHash.Of(CellHash.Column(cellX, CellHash.Key(Seed, 0)), CellHash.Step(cellY, I.Of(0)));
            F kept = FilterFade.Kept(width * F.Of(Math.Max(Columns, Rows)));
            light = F.Of(1) - (Lattice.Lerp(F.Of(0.5), CellHash.ToUnit<F, I>(bits), kept) * F.Of(Variation));
        }
    }

    /// <summary>Share of a box around a place that lies in the middle of the unit intervals, away from the mortar at both ends.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static F Covered<R, F, I>(R place, R width, double mortar)
        where R : unmanaged, ILane<R, F, I>
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I>
    {
        R isPoint = R.LessOrEqual(width, R.Zero);
        R inside = place - R.Floor(place), edge = R.Of(mortar / 2);
        R one = R.Of(1);
        R point = R.LessOrEqual(edge, inside) & R.Less(inside, one - edge) & one;
        if (R.All(isPoint))
        {
            return R.ToSingle(point);
        }

        R half = width * R.Of(0.5);
        R box = (Integral(place + half, mortar) - Integral(place - half, mortar)) / R.Select(isPoint, one, width);
        return R.ToSingle(R.Select(isPoint, point, R.Min(R.Max(box, R.Zero), one)));
    }

    /// <summary>How much of [0, x] is not mortar.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static R Integral<R>(R x, double mortar)
        where R : unmanaged, IReal<R>
    {
        R whole = R.Floor(x), brick = R.Of(1 - mortar);
        return R.Fma(whole, brick, R.Min(R.Max(x - whole - R.Of(mortar / 2), R.Zero), brick));
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private void Colors<F>(F share, F light, out F red, out F green, out F blue)
        where F : unmanaged, IReal<F>
    {
        red = Lattice.Lerp(F.Of(MortarColor.R), F.Of(Brick.R) * light, share);
        green = Lattice.Lerp(F.Of(MortarColor.G), F.Of(Brick.G) * light, share);
        blue = Lattice.Lerp(F.Of(MortarColor.B), F.Of(Brick.B) * light, share);
    }

    /// <summary>The wall, many points at a time.</summary>
    private sealed unsafe class Sampler(BrickTexture wall) : TextureSampler
    {
        public override void Sample<R, F, I>(in LookupBatch<R> lookups, in ColorColumns<F> colors, int packets)
        {
            for (int packet = 0; packet < packets; packet++)
            {
                F width = wall.FilterWidth > 0 ? FootprintWidth.Of<R, F>(lookups, PatternSpace.Uv, packet) * F.Of(wall.FilterWidth) : F.Zero;
                wall.Parts<R, F, I>(lookups.Coordinates.U[packet], lookups.Coordinates.V[packet], width, out F share, out F light);
                wall.Colors(share, light, out colors.R[packet], out colors.G[packet], out colors.B[packet]);
            }
        }
    }
}
