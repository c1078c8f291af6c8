using System.Runtime.CompilerServices;

namespace LabRaytracer;

/// <summary>Means of a checker over footprints, many points at a time.</summary>
/// <remarks>
/// <para>A checker is a product of square waves, one for each axis. Over a box along the axes the mean is the product of the waves' means, which are exact.
/// The footprint, a parallelogram, is cut along its longer side into pieces of at most a quarter of a cell, at most 64; each stands for a box of the
/// same centre and the same extent along each axis (root of the sum of the squares of its sides' extents: the same variance).</para>
/// <para>Exact where the sides lie along the axes. Otherwise what is neglected is the slant of a piece.</para>
/// </remarks>
internal static class CheckerArea
{
    /// <summary>Most pieces of a footprint.</summary>
    public const int MostPieces = 64;

    private const double Farthest = 1e6;

    /// <summary>Mean of the checker in texture space: 1 for even, -1 for odd cells, 0 on lines.</summary>
    /// <param name="u">Centre, cells.</param>
    /// <param name="v">Centre, cells.</param>
    /// <param name="sides">Sides of the footprint, cells.</param>
    /// <param name="half">Half the width of lines, cells.</param>
    /// <param name="gap">Share outside of lines.</param>
    [MethodImpl(MethodImplOptions.NoInlining)]
    public static R Mean<R>(R u, R v, in CheckerSides<R> sides, double half, out R gap)
        where R : unmanaged, IReal<R>
    {
        R pieces = sides.Pieces(), step = R.Of(1) / pieces;
        R alongU = sides.LongU * step, alongV = sides.LongV * step;
        R widthU = Extent(sides.ShortU, alongU), widthV = Extent(sides.ShortV, alongV);
        R sum = R.Zero, open = R.Zero;
        for (int piece = 0; piece < MostPieces; piece++)
        {
            R isOn = R.Less(R.Of(piece), pieces);
            if (!R.Any(isOn))
            {
                break;
            }

            R place = R.Of(piece + 0.5) - (pieces * R.Of(0.5));
            R atU = R.Fma(place, alongU, u), atV = R.Fma(place, alongV, v);
            sum += isOn & (SquareWave.Mean(atU, widthU, SquareWave.At(atU, half), half) * SquareWave.Mean(atV, widthV, SquareWave.At(atV, half), half));
            open += half > 0 ? isOn & (SquareWave.Gap(atU, widthU, half) * SquareWave.Gap(atV, widthV, half)) : R.Zero;
        }

        gap = half > 0 ? open * step : R.Of(1);
        return sum * step;
    }

    /// <summary>Mean of the checker in the object: 1 for even, -1 for odd cells.</summary>
    /// <param name="at">Centre, cells.</param>
    /// <param name="point">The square waves at the centre.</param>
    /// <param name="sides">Sides of the footprint, cells.</param>
    [MethodImpl(MethodImplOptions.NoInlining)]
    public static R Mean<R>(in CheckerPoint<R> at, in CheckerPoint<R> point, in CheckerSides<R> sides)
        where R : unmanaged, IReal<R>
    {
        R pieces = sides.Pieces(), step = R.Of(1) / pieces;
        R alongU = sides.LongU * step, alongV = sides.LongV * step, alongW = sides.LongW * step;
        R widthU = Extent(sides.ShortU, alongU), widthV = Extent(sides.ShortV, alongV), widthW = Extent(sides.ShortW, alongW);
        R sum = R.Zero;
        for (int piece = 0; piece < MostPieces; piece++)
        {
            R isOn = R.Less(R.Of(piece), pieces);
            if (!R.Any(isOn))
            {
                break;
            }

            R place = R.Of(piece + 0.5) - (pieces * R.Of(0.5));
            R product = SquareWave.Mean(R.Fma(place, alongU, at.U), widthU, point.U, 0)
                * SquareWave.Mean(R.Fma(place, alongV, at.V), widthV, point.V, 0)
                * SquareWave.Mean(R.Fma(place, alongW, at.W), widthW, point.W, 0);
            sum += isOn & product;
        }

        return sum * step;
    }

    /// <summary>A number of cells that sums can bear; NaN counts as far.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static R Bound<R>(R cells)
        where R : unmanaged, IReal<R> => R.Max(R.Min(cells, R.Of(Farthest)), R.Of(-Farthest));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static R Extent<R>(R a, R b)
        where R : unmanaged, IReal<R> => R.Sqrt(R.Fma(a, a, b * b));
}
