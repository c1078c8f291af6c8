using System.Runtime.CompilerServices;
using System.Runtime.InteropServices;

namespace LabRaytracer;

/// <summary>The grid for covering a sphere (Polish: siatka przeznaczona do pokrycia sfery) of lab sheet IV, figures 7 and 8: a test card for mappings.</summary>
/// <remarks>
/// <para>The first column is red, the last green, the cells of the bottom and top rows between them yellow, all others near white. Every second cell shows
/// the number of its column; the rest show, in turn, an arrow that points to larger v and a letter R, so that a mapping that mirrors or turns is seen at once.</para>
/// <para>Outside [0, 1] the grid repeats, or stays at its last row where the mapping asks to clamp v. Drawn from (u, v) alone, sharp at any size.
/// Immutable, thread safe.</para>
/// <para>With <see cref="PatternFilter.Area"/> the colour is the exact mean over footprints along the axes, and near it over others: cells, lines and signs alike.</para>
/// </remarks>
public sealed unsafe class GridTexture : IPreparedTexture
{
    private const int Paper = 0, Red = 1, Green = 2, Yellow = 3, Ink = 4;

    private static readonly float[] s_palette = Palette();

    private readonly int _columns = 24;
    private readonly int _rows = 12;
    private readonly double _lineWidth = 0.06;
    private readonly Lazy<GridArea> _area;

    /// <summary>A grid of 24 x 12 cells.</summary>
    public GridTexture() => _area = new Lazy<GridArea>(() => new GridArea(this));

    /// <summary>Cells along u from 0 to 1, [2, 100]. Default: 24.</summary>
    /// <exception cref="ArgumentOutOfRangeException">Outside [2, 100].</exception>
    public int Columns
    {
        get => _columns;
        init => _columns = CellCount(value);
    }

    /// <summary>Cells along v from 0 to 1, [2, 100]. Default: 12, which makes them square where the picture is 2:1.</summary>
    /// <exception cref="ArgumentOutOfRangeException">Outside [2, 100].</exception>
    public int Rows
    {
        get => _rows;
        init => _rows = CellCount(value);
    }

    /// <summary>Width of the lines between cells, cells, [0, 1]. Default: 0.06.</summary>
    /// <exception cref="ArgumentOutOfRangeException">Outside [0, 1] or NaN.</exception>
    public double LineWidth
    {
        get => _lineWidth;
        init => _lineWidth = value is >= 0 and <= 1
            ? value
            : throw new ArgumentOutOfRangeException(nameof(value), value, "The line width of a grid must be in [0, 1] cells.");
    }

    /// <summary>Whether colours are those of points or means over what samples cover. Default: nearest, points.</summary>
    /// <exception cref="ArgumentOutOfRangeException">Not a value of the enumeration.</exception>
    public PatternFilter Filter { get; init => field = PropertyChecks.Known(value); }

    /// <inheritdoc/>
    public TextureNeeds Needs => TextureNeeds.Coordinate | (Filter == PatternFilter.Area ? TextureNeeds.Footprint : TextureNeeds.None);

    /// <inheritdoc/>
    public Intensity Sample(in TextureLookup lookup) => Filter == PatternFilter.Area
        ? _area.Value.Mean(lookup.Coordinate.U, lookup.Coordinate.V, lookup.Footprint, lookup.WrapV)
        : At(lookup.Coordinate.U, lookup.Coordinate.V, lookup.WrapV);

    /// <summary>The colour at a point.</summary>
    internal Intensity At(double u, double v, TextureWrap wrapV)
    {
        Int1 color = ColorAt<Double1, Float1, Int1>(new Double1(u), new Double1(v), wrapV);
        return new Intensity(s_palette[3 * color.Value], s_palette[(3 * color.Value) + 1], s_palette[(3 * color.Value) + 2]);
    }

    TextureNeeds IPreparedTexture.NeedsUnder(TextureFilter? filter) => filter == TextureFilter.Nearest ? Needs & ~TextureNeeds.Footprint : Needs;

    TextureSampler IPreparedTexture.Prepare(TextureUse use, TextureFilter? filter) =>
        Filter == PatternFilter.Area && filter != TextureFilter.Nearest ? new GridAreaSampler(_area.Value) : new Sampler(this);

    /// <summary>Number of the colour at a point.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private I ColorAt<R, F, I>(R u, R v, TextureWrap wrapV)
        where R : unmanaged, ILane<R, F, I>
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I>
    {
        R one = R.Of(1);
        R x = (u - R.Floor(u)) * R.Of(Columns);
        R y = (wrapV is TextureWrap.Clamp or TextureWrap.Pole ? R.Max(R.Min(v, one), R.Zero) : v - R.Floor(v)) * R.Of(Rows);

        // The minimum also keeps v = 1 in the top row, and lanes without a point (any bits, NaN) inside the tables.
        R column = R.Min(R.Floor(x), R.Of(Columns - 1)), row = R.Min(R.Floor(y), R.Of(Rows - 1));
        R insideX = x - column, insideY = y - row, half = R.Of(LineWidth / 2);
        R line = R.Less(insideX, half) | R.Less(one - half, insideX) | R.Less(insideY, half) | R.Less(one - half, insideY);
        I i = R.ToInt32(column), j = R.ToInt32(row);
        I dot = I.Gather(GridGlyphs.Dots, (Glyph(i, j) * I.Of(GridGlyphs.Area)) + (Dot<R, F, I>(insideY) * I.Of(GridGlyphs.Side)) + Dot<R, F, I>(insideX));
        I isInk = R.MaskToInt32(line) | I.Equal(dot, I.Of(1));
        return I.Select(isInk, I.Of(Ink), CellColor(i, j));
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private I CellColor<I>(I column, I row)
        where I : unmanaged, IIndexLane<I>
    {
        I polar = I.Equal(row, I.Of(0)) | I.Equal(row, I.Of(Rows - 1));
        I color = I.Select(polar, I.Of(Yellow), I.Of(Paper));
        color = I.Select(I.Equal(column, I.Of(Columns - 1)), I.Of(Green), color);
        return I.Select(I.Equal(column, I.Of(0)), I.Of(Red), color);
    }

    /// <summary>Number of the glyph in a cell: like a chessboard, the column's number in one half of the cells, arrow and R in turn in the other.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static I Glyph<I>(I column, I row)
        where I : unmanaged, IIndexLane<I>
    {
        I one = I.Of(1), sum = column + row;
        I sign = I.Of(GridGlyphs.Arrow) + (I.ShiftRight(sum, 1) & one);
        return I.Select(I.Equal(sum & one, one), column, sign);
    }

    /// <summary>Dot of a glyph along one axis, [0, 8], of the place inside the cell, [0, 1].</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static I Dot<R, F, I>(R inside)
        where R : unmanaged, ILane<R, F, I>
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I> => R.ToInt32(R.Min(R.Floor(inside * R.Of(GridGlyphs.Side)), R.Of(GridGlyphs.Side - 1)));

    /// <summary>Paper, red, green, yellow, ink; linear, in memory that does not move.</summary>
    private static float[] Palette()
    {
        ReadOnlySpan<float> colors = [0.82f, 0.82f, 0.78f, 0.72f, 0.03f, 0.02f, 0.03f, 0.42f, 0.06f, 0.9f, 0.68f, 0.03f, 0.02f, 0.025f, 0.04f];
        float[] palette = GC.AllocateUninitializedArray<float>(colors.Length, pinned: true);
        colors.CopyTo(palette);
        return palette;
    }

    private static int CellCount(int value) => value is >= 2 and <= 100
        ? value
        : throw new ArgumentOutOfRangeException(nameof(value), value, "The number of cells must be in [2, 100]; column numbers have two digits.");

    /// <summary>The grid, many points at a time.</summary>
    private sealed class Sampler(GridTexture grid) : TextureSampler
    {
        public override void Sample<R, F, I>(in LookupBatch<R> lookups, in ColorColumns<F> colors, int packets)
        {
            F* palette = (F*)Marshal.UnsafeAddrOfPinnedArrayElement(s_palette, 0);
            for (int packet = 0; packet < packets; packet++)
            {
                I color = grid.ColorAt<R, F, I>(lookups.Coordinates.U[packet], lookups.Coordinates.V[packet], lookups.WrapV) * I.Of(3);
                colors.R[packet] = F.Gather(palette, color);
                colors.G[packet] = F.Gather(palette, color + I.Of(1));
                colors.B[packet] = F.Gather(palette, color + I.Of(2));
            }
        }
    }
}
