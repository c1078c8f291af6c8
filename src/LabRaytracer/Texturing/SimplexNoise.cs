using System.Runtime.CompilerServices;

namespace LabRaytracer;

/// <summary>Simplex noise: space is cut into tetrahedra, and the gradients of their four corners fade out before they reach the next tetrahedron.</summary>
/// <remarks>
/// <para>K. Perlin, "Noise hardware", SIGGRAPH course notes 2001: cells of a cube lattice squeezed along its diagonal, p' = p + (x + y + z) / 3, each cut into six tetrahedra by the
/// order of the fractions of p'. A corner at the distance d adds (1/2 - d²)⁴ (gradient . way), nothing from d² = 1/2 on, which is the height of a tetrahedron: so the noise
/// is three times continuously differentiable everywhere. Gradients and hash are those of <see cref="GradientNoise"/>.</para>
/// <para>The sum for the worst gradients is largest on the edge midway between two faces, 0.0130071572 (maximised numerically); times 76.88 it is below 1.</para>
/// </remarks>
internal static class SimplexNoise
{
    private const double Scale = 76.88;

    /// <summary>The noise at points, [-1, 1].</summary>
    /// <param name="x">Coordinate in cells.</param>
    /// <param name="y">Coordinate in cells.</param>
    /// <param name="z">Coordinate in cells.</param>
    /// <param name="key">Key of the layer.</param>
    [MethodImpl(MethodImplOptions.NoInlining)]
    public static F At<R, F, I>(R x, R y, R z, int key)
        where R : unmanaged, ILane<R, F, I>
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I>
    {
        R skew = (x + y + z) * R.Of(1.0 / 3);
        I cellX = Lattice.Cell<R, F, I>(x + skew, out F insideX);
        I cellY = Lattice.Cell<R, F, I>(y + skew, out F insideY);
        I cellZ = Lattice.Cell<R, F, I>(z + skew, out F insideZ);

        // Way from the cell's first corner, before the squeeze.
        F shift = (insideX + insideY + insideZ) * F.Of(1.0 / 6);
        F wayX = insideX - shift, wayY = insideY - shift, wayZ = insideZ - shift;

        // From the first corner to the last one a step along each axis, the largest fraction's first.
        F xy = F.LessOrEqual(insideY, insideX), xz = F.LessOrEqual(insideZ, insideX), yz = F.LessOrEqual(insideZ, insideY);
        F zero = F.Zero, all = F.True, two = F.Of(1.0 / 3);
        Corner<F, I> corner = new(cellX, cellY, cellZ, key);
        F sum = corner.Part(zero, zero, zero, wayX, wayY, wayZ);
        sum += corner.Part(xy & xz, ~xy & yz, ~xz & ~yz, wayX + F.Of(1.0 / 6), wayY + F.Of(1.0 / 6), wayZ + F.Of(1.0 / 6));
        sum += corner.Part(xy | xz, ~xy | yz, ~xz | ~yz, wayX + two, wayY + two, wayZ + two);
        sum += corner.Part(all, all, all, wayX + F.Of(0.5), wayY + F.Of(0.5), wayZ + F.Of(0.5));
        return sum * F.Of(Scale);
    }

    /// <summary>A cell, for its corners.</summary>
    private readonly struct Corner<F, I>(I cellX, I cellY, I cellZ, int key)
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I>
    {
        /// <summary>What a corner adds.</summary>
        /// <param name="stepX">Mask: the corner lies a step along x.</param>
        /// <param name="stepY">Mask: the corner lies a step along y.</param>
        /// <param name="stepZ">Mask: the corner lies a step along z.</param>
        /// <param name="x">Way from the corner, but for the step along x.</param>
        /// <param name="y">Way from the corner, but for the step along y.</param>
        /// <param name="z">Way from the corner, but for the step along z.</param>
        [MethodImpl(MethodImplOptions.NoInlining)]
        public F Part(F stepX, F stepY, F stepZ, F x, F y, F z)
        {
            F one = F.Of(1);
            x -= stepX & one;
            y -= stepY & one;
            z -= stepZ & one;
            F near = F.Max(F.Of(0.5) - F.Fma(x, x, F.Fma(y, y, z * z)), F.Zero);
            I column = CellHash.Column(Lattice.Next(cellX, F.MaskToInt32(stepX) & I.Of(1)), key);
            I step = CellHash.Step(Lattice.Next(cellY, F.MaskToInt32(stepY) & I.Of(1)), Lattice.Next(cellZ, F.MaskToInt32(stepZ) & I.Of(1)));
            near *= near;
            return near * near * GradientNoise.Slope(CellHash.Of(column, step), x, y, z);
        }
    }
}
