namespace LabRaytracer;

/// <summary>Where in a pyramid the texels of one lookup lie.</summary>
/// <param name="numbers">What <see cref="Store"/> wrote, at the lane of the lookup.</param>
/// <param name="width">Lanes of the group.</param>
internal readonly unsafe struct EwaPlace(int* numbers, int width)
{
    /// <summary>How many groups of numbers <see cref="Store"/> writes for a group of lookups.</summary>
    public const int Numbers = 5;

    /// <summary>The level.</summary>
    public int Level => numbers[0];

    /// <summary>Column of the texel to the left of the centre and below it.</summary>
    public int Column => numbers[width];

    /// <summary>Its row.</summary>
    public int Row => numbers[2 * width];

    /// <summary>Number of that texel in the pyramid, if it lies inside the level.</summary>
    public int Texel => numbers[3 * width];

    /// <summary>From a texel of the pyramid to the one above it.</summary>
    public int Stride => numbers[4 * width];

    /// <summary>Writes the places of a group of lookups.</summary>
    /// <param name="level">Levels.</param>
    /// <param name="start">Texels at which they start.</param>
    /// <param name="stride">From a row of theirs to the next one.</param>
    /// <param name="column">Columns of the texels.</param>
    /// <param name="row">Rows of the texels.</param>
    /// <param name="numbers">Receives <see cref="Numbers"/> groups.</param>
    public static void Store<I>(I level, I start, I stride, I column, I row, int* numbers)
        where I : unmanaged, IIndexLane<I>
    {
        I.Store(level, numbers);
        I.Store(column, numbers + I.Width);
        I.Store(row, numbers + (2 * I.Width));
        I.Store(start + (row * stride) + column, numbers + (3 * I.Width));
        I.Store(stride, numbers + (4 * I.Width));
    }

    /// <summary>Mask of the lookups whose blocks of texels lie inside their levels or not far from it. Blocks may begin up to a texel before the reach and end four behind it.</summary>
    /// <param name="texel">Column or row of the texel at the centre.</param>
    /// <param name="size">Columns or rows of the level.</param>
    /// <param name="reach">Half the extent of the footprint, whole texels.</param>
    /// <param name="margin">How far beyond the ends texels lie that may be read.</param>
    public static I IsInside<I>(I texel, I size, I reach, int margin)
        where I : unmanaged, IIndexLane<I> => ~I.Less(texel, reach + I.Of(2 - margin)) & I.Less(texel, size - reach - I.Of(6 - margin));
}
