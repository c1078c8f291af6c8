using System.Runtime.CompilerServices;

namespace LabRaytracer;

/// <summary>The unit lattice that noises are made on.</summary>
/// <remarks>
/// Cells are numbered by floor, so that there is no fold at 0, and modulo 2^24. The fraction is taken in the precision of the geometry before it becomes a float:
/// in double precision it is exact to 2^-53 of the coordinate, so a pattern at 1e6 is as fine as at 0.
/// </remarks>
internal static class Lattice
{
    private const int Mask = (1 << 24) - 1;

    /// <summary>The number of the cell of a coordinate, [0, 2^24), and the place inside of it, [0, 1]. Numbers that are not finite count as 0.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static I Cell<R, F, I>(R coordinate, out F fraction)
        where R : unmanaged, ILane<R, F, I>
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I>
    {
        R cell = R.Floor(coordinate);
        R inside = coordinate - cell;
        fraction = R.ToSingle(R.Equal(inside, inside) & inside);
        R inRange = cell - (R.Floor(cell * R.Of(1.0 / (1 << 24))) * R.Of(1 << 24));
        return R.ToInt32(R.Max(inRange, R.Zero));
    }

    /// <summary>The number of the cell a few steps on.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static I Next<I>(I cell, int steps)
        where I : unmanaged, IIndexLane<I> => Next(cell, I.Of(steps));

    /// <summary>The numbers of cells a few steps on, each by its own number of steps.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static I Next<I>(I cell, I steps)
        where I : unmanaged, IIndexLane<I> => (cell + steps) & I.Of(Mask);

    /// <summary>Linear interpolation.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static F Lerp<F>(F a, F b, F share)
        where F : unmanaged, IReal<F> => F.Fma(share, b - a, a);
}
