using System.Runtime.CompilerServices;

namespace LabRaytracer;

/// <summary>Where a group of lookups reads one level of a pyramid: which pairs of texels, and how much of each. Lives on the stack.</summary>
/// <remarks>Behind the last texel of a row lies the first one again (<see cref="MipPyramid"/>), so that two neighbours are always one load.</remarks>
internal static unsafe class MipPairs
{
    /// <summary>How many groups of numbers <see cref="Locate"/> writes for a group of lookups.</summary>
    public const int Numbers = 4;

    /// <summary>Locates the texels of a group of lookups.</summary>
    /// <param name="pyramid">The levels.</param>
    /// <param name="level">A level a lane, from 1 on.</param>
    /// <param name="wrapU">What lies beyond the columns.</param>
    /// <param name="wrapV">What lies beyond the rows.</param>
    /// <param name="x">Columns as parts of the width, [0, 1].</param>
    /// <param name="y">Rows as parts of the height, [0, 1].</param>
    /// <param name="numbers">Receives <see cref="Numbers"/> groups of lanes.</param>
    [MethodImpl(MethodImplOptions.NoInlining)]
    public static void Locate<F, I>(MipPyramid pyramid, in I level, TextureWrap wrapU, TextureWrap wrapV, in F x, in F y, F* numbers)
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I>
    {
        MipLevels.Find(pyramid, level, out I width, out I height, out I start, out I stride);
        F px = F.Fma(x, F.FromInt32(width), F.Of(-0.5)), py = F.Fma(y, F.FromInt32(height), F.Of(-0.5)), fx = F.Floor(px), fy = F.Floor(py);
        I column = F.ToInt32(fx), row = F.ToInt32(fy), zero = I.Of(0), one = I.Of(1), lastColumn = width - one, lastRow = height - one;
        F right = px - fx;
        I left = I.Min(column, lastColumn), isBefore = I.Less(left, zero), below, above;
        if (wrapU == TextureWrap.Repeat)
        {
            left = I.Select(isBefore, lastColumn, left);
        }
        else
        {
            // Beyond an end lies its texel: none of the next one.
            right = ~F.MaskFromInt32(isBefore | I.Equal(left, lastColumn)) & right;
            left = I.Max(left, zero);
        }

        if (wrapV == TextureWrap.Repeat)
        {
            below = I.Min(row, lastRow);
            below = I.Select(I.Less(below, zero), lastRow, below);
            above = I.Less(below, lastRow) & (below + one);
        }
        else
        {
            below = I.Max(I.Min(row, lastRow), zero);
            above = I.Max(I.Min(row + one, lastRow), zero);
        }

        I lower = left, upper = left;
        if (wrapV == TextureWrap.Pole)
        {
            // Beyond a pole lies the row nearest to it, half a turn away.
            I turned = left + I.ShiftRight(width, 1);
            turned = I.Select(I.Less(turned, width), turned, turned - width);
            lower = I.Select(I.Less(row, zero), turned, left);
            upper = I.Select(I.Less(lastRow, row + one), turned, left);
        }

        I channels = I.Of(MipPyramid.Channels);
        I.Store((start + (below * stride) + lower) * channels, (int*)numbers);
        I.Store((start + (above * stride) + upper) * channels, (int*)(numbers + 1));
        numbers[2] = right;
        numbers[3] = py - fy;
    }

    /// <summary>The mixture of two pairs, one lookup: red, green, blue, 1.</summary>
    /// <param name="texels">Texels of the pyramid.</param>
    /// <param name="numbers">What <see cref="Locate"/> wrote, at the lane of the lookup.</param>
    /// <param name="width">Lanes of the group.</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Float4 Mix(float* texels, float* numbers, int width)
    {
        Float8 lower = *(Float8*)(texels + ((int*)numbers)[0]), upper = *(Float8*)(texels + ((int*)numbers)[width]);
        Float8 column = Float8.Fma(Float8.Of(numbers[3 * width]), upper - lower, lower);
        Float4 left = Float8.Lower(column);
        return Float4.Fma(Float4.Of(numbers[2 * width]), Float8.Upper(column) - left, left);
    }
}
