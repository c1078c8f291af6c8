using System.Runtime.CompilerServices;

namespace LabRaytracer;

/// <summary>The square wave that is 1 in even and -1 in odd cells of length 1, and its means; written over lanes.</summary>
/// <remarks>Means are differences of the wave's integral, a triangle wave: exact up to rounding, below 1e-6 in default lanes.</remarks>
internal static class SquareWave
{
    /// <summary>The mean of the wave over an interval.</summary>
    /// <param name="centre">Centre of the interval, cells.</param>
    /// <param name="width">Its length, cells, at least 0.</param>
    /// <param name="point">The wave at the centre: the mean over intervals too short for a difference.</param>
    /// <param name="half">Half the width of lines around whole numbers, in which the wave counts 0; [0, 1/2].</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static R Mean<R>(R centre, R width, R point, double half)
        where R : unmanaged, IReal<R>
    {
        // Near 0 the ends of the interval keep their digits.
        R near = centre - (R.Of(2) * R.Floor(centre * R.Of(0.5))), reach = width * R.Of(0.5);
        R mean = (Integral(near + reach, half) - Integral(near - reach, half)) / width;
        return R.Select(IsShort(width), point, mean);
    }

    /// <summary>The mean of what lies outside of lines: the absolute value of the wave.</summary>
    /// <param name="centre">Centre of the interval, cells.</param>
    /// <param name="width">Its length, cells, at least 0.</param>
    /// <param name="half">Half the width of lines, [0, 1/2].</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static R Gap<R>(R centre, R width, double half)
        where R : unmanaged, IReal<R>
    {
        R near = centre - R.Floor(centre), reach = width * R.Of(0.5);
        R mean = (GapIntegral(near + reach, half) - GapIntegral(near - reach, half)) / width;
        return R.Select(IsShort(width), IsOpen(near, half) & R.Of(1), mean);
    }

    /// <summary>The wave at a point, 0 on a line.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static R At<R>(R point, double half)
        where R : unmanaged, IReal<R>
    {
        R cell = R.Floor(point);
        return IsOpen(point - cell, half) & Sign(cell);
    }

    /// <summary>1 for even, -1 for odd numbers of cells.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static R Sign<R>(R cell)
        where R : unmanaged, IReal<R>
    {
        R half = cell * R.Of(0.5);
        return R.Fma(R.Floor(half) - half, R.Of(4), R.Of(1));
    }

    /// <summary>Mask of intervals over which the difference of integrals would be rounding alone.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static R IsShort<R>(R width)
        where R : unmanaged, IReal<R> => R.Less(width, R.Of(R.IsSingle ? 1.0 / (1 << 12) : 1.0 / (1 << 30)));

    /// <summary>Mask of places in a cell that lie on no line.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static R IsOpen<R>(R place, double half)
        where R : unmanaged, IReal<R> => R.LessOrEqual(R.Of(half), place) & R.LessOrEqual(place, R.Of(1) - R.Of(half));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static R Integral<R>(R end, double half)
        where R : unmanaged, IReal<R>
    {
        R one = R.Of(1), turn = end - (R.Of(2) * R.Floor(end * R.Of(0.5)));
        return Open(one - R.Abs(turn - one), half);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static R GapIntegral<R>(R end, double half)
        where R : unmanaged, IReal<R>
    {
        R cell = R.Floor(end);
        return R.Fma(cell, R.Of(1 - (2 * half)), Open(end - cell, half));
    }

    /// <summary>How much of the first part of a cell lies outside of lines.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static R Open<R>(R part, double half)
        where R : unmanaged, IReal<R> => R.Min(R.Max(part - R.Of(half), R.Zero), R.Of(1 - (2 * half)));
}
