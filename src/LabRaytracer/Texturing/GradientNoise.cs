using System.Runtime.CompilerServices;

namespace LabRaytracer;

/// <summary>Improved Perlin noise: each lattice point has one of twelve gradients, blended by a quintic.</summary>
/// <remarks>
/// K. Perlin, "Improving noise", ACM TOG 21(3), 2002: gradients towards the middles of a cube's edges, 6 t⁵ - 15 t⁴ + 10 t³ between lattice points.
/// 0 at every lattice point; twice continuously differentiable. The gradient comes from a hash of the cell instead of Perlin's table.
/// </remarks>
internal static class GradientNoise
{
    /// <summary>The noise at points, [-1.0364, 1.0364] (a bound by the largest sum of corners; see the tests' reference).</summary>
    /// <param name="x">Coordinate in cells.</param>
    /// <param name="y">Coordinate in cells.</param>
    /// <param name="z">Coordinate in cells.</param>
    /// <param name="key">Key of the layer.</param>
    /// <param name="isFlat">True if z is 0 everywhere: half of the corners have no weight then.</param>
    [MethodImpl(MethodImplOptions.NoInlining)]
    public static F At<R, F, I>(R x, R y, R z, int key, bool isFlat)
        where R : unmanaged, ILane<R, F, I>
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I>
    {
        I cellX = Lattice.Cell<R, F, I>(x, out F insideX);
        I cellY = Lattice.Cell<R, F, I>(y, out F insideY);
        I cellZ = Lattice.Cell<R, F, I>(z, out F insideZ);
        I left = CellHash.Column(cellX, key), right = CellHash.Column(Lattice.Next(cellX, 1), key);
        F near = Plane(left, right, cellY, cellZ, insideX, insideY, insideZ);
        return isFlat
            ? near
            : Lattice.Lerp(near, Plane(left, right, cellY, Lattice.Next(cellZ, 1), insideX, insideY, insideZ - F.Of(1)), Fade(insideZ));
    }

    /// <summary>The four corners with one z.</summary>
    [MethodImpl(MethodImplOptions.NoInlining)]
    private static F Plane<F, I>(I left, I right, I cellY, I cellZ, F x, F y, F z)
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I>
    {
        F one = F.Of(1), across = Fade(x);
        I low = CellHash.Step(cellY, cellZ), high = CellHash.Step(Lattice.Next(cellY, 1), cellZ);
        F bottom = Lattice.Lerp(Slope(CellHash.Of(left, low), x, y, z), Slope(CellHash.Of(right, low), x - one, y, z), across);
        F top = Lattice.Lerp(Slope(CellHash.Of(left, high), x, y - one, z), Slope(CellHash.Of(right, high), x - one, y - one, z), across);
        return Lattice.Lerp(bottom, top, Fade(y));
    }

    /// <summary>The product of a lattice point's gradient with the way from there; four of the twelve gradients have two numbers.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static F Slope<F, I>(I bits, F x, F y, F z)
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I>
    {
        I number = I.ShiftRight(bits, 28), zero = I.Of(0);
        F first = F.Select(F.MaskFromInt32(I.Less(number, I.Of(8))), x, y);
        F last = F.Select(F.MaskFromInt32(I.Equal(number & I.Of(13), I.Of(12))), x, z);
        F second = F.Select(F.MaskFromInt32(I.Less(number, I.Of(4))), y, last);
        first = F.Select(F.MaskFromInt32(I.Equal(number & I.Of(1), zero)), first, -first);
        second = F.Select(F.MaskFromInt32(I.Equal(number & I.Of(2), zero)), second, -second);
        return first + second;
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static F Fade<F>(F t)
        where F : unmanaged, IReal<F> => t * t * t * F.Fma(t, F.Fma(t, F.Of(6), F.Of(-15)), F.Of(10));
}
