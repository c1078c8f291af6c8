using System.Runtime.CompilerServices;

namespace LabRaytracer;

/// <summary>Value noise: each lattice point has a random number in [-1, 1), interpolated in between.</summary>
internal static class ValueNoise
{
    /// <summary>Trilinear interpolation, [-1, 1): continuous, with creases at the faces of the cells.</summary>
    /// <param name="x">Coordinate in cells.</param>
    /// <param name="y">Coordinate in cells.</param>
    /// <param name="z">Coordinate in cells.</param>
    /// <param name="key">Key of the layer.</param>
    /// <param name="isFlat">True if z is 0 everywhere.</param>
    [MethodImpl(MethodImplOptions.NoInlining)]
    public static F Linear<R, F, I>(R x, R y, R z, int key, bool isFlat)
        where R : unmanaged, ILane<R, F, I>
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I>
    {
        I cellX = Lattice.Cell<R, F, I>(x, out F insideX);
        I cellY = Lattice.Cell<R, F, I>(y, out F insideY);
        I cellZ = Lattice.Cell<R, F, I>(z, out F insideZ);
        I left = CellHash.Column(cellX, key), right = CellHash.Column(Lattice.Next(cellX, 1), key);
        F near = Plane(left, right, cellY, cellZ, insideX, insideY);
        return isFlat ? near : Lattice.Lerp(near, Plane(left, right, cellY, Lattice.Next(cellZ, 1), insideX, insideY), insideZ);
    }

    /// <summary>Catmull-Rom interpolation over 4 x 4 x 4 lattice points: continuous with its slope; clamped to [-1, 1], because the cubic overshoots.</summary>
    /// <param name="x">Coordinate in cells.</param>
    /// <param name="y">Coordinate in cells.</param>
    /// <param name="z">Coordinate in cells.</param>
    /// <param name="key">Key of the layer.</param>
    /// <param name="isFlat">True if z is 0 everywhere.</param>
    [MethodImpl(MethodImplOptions.NoInlining)]
    public static F Cubic<R, F, I>(R x, R y, R z, int key, bool isFlat)
        where R : unmanaged, ILane<R, F, I>
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I>
    {
        I cellX = Lattice.Cell<R, F, I>(x, out F insideX);
        I cellY = Lattice.Cell<R, F, I>(y, out F insideY);
        I cellZ = Lattice.Cell<R, F, I>(z, out F insideZ);
        LatticeRow<F, I> row = new(cellX, insideX, key);
        if (isFlat)
        {
            return Clamp(row.Plane(cellY, cellZ, insideY));
        }

        F sum = F.Zero;
        for (int step = -1; step <= 2; step++)
        {
            sum = F.Fma(Weight(insideZ, step), row.Plane(cellY, Lattice.Next(cellZ, step), insideY), sum);
        }

        return Clamp(sum);
    }

    [MethodImpl(MethodImplOptions.NoInlining)]
    private static F Plane<F, I>(I left, I right, I cellY, I cellZ, F x, F y)
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I>
    {
        I low = CellHash.Step(cellY, cellZ), high = CellHash.Step(Lattice.Next(cellY, 1), cellZ);
        F bottom = Lattice.Lerp(Number<F, I>(left, low), Number<F, I>(right, low), x);
        F top = Lattice.Lerp(Number<F, I>(left, high), Number<F, I>(right, high), x);
        return Lattice.Lerp(bottom, top, y);
    }

    /// <summary>The number of a lattice point.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static F Number<F, I>(I column, I step)
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I> => (CellHash.ToUnit<F, I>(CellHash.Of(column, step)) * F.Of(2)) - F.Of(1);

    /// <summary>Weight of the lattice point <paramref name="step"/> cells on: the Catmull-Rom cubic.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static F Weight<F>(F t, int step)
        where F : unmanaged, IReal<F> => step switch
        {
            -1 => t * F.Fma(t, F.Fma(t, F.Of(-0.5), F.Of(1)), F.Of(-0.5)),
            0 => F.Fma(t * t, F.Fma(t, F.Of(1.5), F.Of(-2.5)), F.Of(1)),
            1 => t * F.Fma(t, F.Fma(t, F.Of(-1.5), F.Of(2)), F.Of(0.5)),
            _ => t * t * F.Fma(t, F.Of(0.5), F.Of(-0.5)),
        };

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static F Clamp<F>(F value)
        where F : unmanaged, IReal<F> => F.Min(F.Max(value, F.Of(-1)), F.Of(1));

    /// <summary>Four lattice points along x and their weights.</summary>
    private readonly struct LatticeRow<F, I>
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I>
    {
        private readonly I _before, _left, _right, _after;
        private readonly F _beforeShare, _leftShare, _rightShare, _afterShare;

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public LatticeRow(I cell, F inside, int key)
        {
            (_before, _left) = (CellHash.Column(Lattice.Next(cell, -1), key), CellHash.Column(cell, key));
            (_right, _after) = (CellHash.Column(Lattice.Next(cell, 1), key), CellHash.Column(Lattice.Next(cell, 2), key));
            (_beforeShare, _leftShare, _rightShare, _afterShare) = (Weight(inside, -1), Weight(inside, 0), Weight(inside, 1), Weight(inside, 2));
        }

        /// <summary>The 4 x 4 lattice points with one z.</summary>
        [MethodImpl(MethodImplOptions.NoInlining)]
        public F Plane(I cellY, I cellZ, F insideY)
        {
            F sum = F.Zero;
            for (int step = -1; step <= 2; step++)
            {
                I line = CellHash.Step(Lattice.Next(cellY, step), cellZ);
                F across = (Number<F, I>(_before, line) * _beforeShare) + (Number<F, I>(_left, line) * _leftShare)
                    + (Number<F, I>(_right, line) * _rightShare) + (Number<F, I>(_after, line) * _afterShare);
                sum = F.Fma(Weight(insideY, step), across, sum);
            }

            return sum;
        }
    }
}
