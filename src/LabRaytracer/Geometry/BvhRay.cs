using System.Numerics;
using System.Runtime.CompilerServices;

namespace LabRaytracer;

/// <summary>Rays prepared for boxes in floats, so that no box is missed that holds a hit.</summary>
/// <remarks>
/// <para>With m the largest component of a direction, the ray parameter in floats is t m, and the slopes are m / d in [1, 2^50]: a smaller component counts as 2^-50 m,
/// which moves the ray by less than 2^-50 of its way through the tree's box.</para>
/// <para>Let o be an origin's coordinate and b the largest coordinate of the tree's box, both relative to the tree's centre, u = 2^-24, and e the unit roundoff of the
/// lanes (2^-53, or u). The float plane at c is wrong by at most u (2 |c| + 4 |o|) of length along its axis: two roundings of the slope, three of the offset, one of the
/// fma. The triangle test may find a point up to 8 e D beside the exact ray, with D the sum of all coordinates of ray and box: each sheared vertex is wrong by up to
/// 4 e D, and weights wrong by 2 e move a mean of vertices that lie within D. Every plane is moved outward by w = 8 u (|o| + b) + 16 e D, which covers all of it, the
/// 2^-50 above and the rounding of w itself.</para>
/// </remarks>
/// <typeparam name="R">Lane type of geometry.</typeparam>
/// <typeparam name="F">Float lanes of the same width.</typeparam>
/// <typeparam name="I">Integer lanes of the same width.</typeparam>
internal struct BvhRay<R, F, I>
    where R : unmanaged, ILane<R, F, I>
    where F : unmanaged, ILane<F, F, I>
    where I : unmanaged, IIndexLane<I>
{
    private const double SmallestSlope = 8.881784197001252e-16;
    private const double LargestInverse = 1125899906842624;

    /// <summary>The three axes.</summary>
    public BvhSlab<F> X, Y, Z;

    /// <summary>Bits of the active lanes whose direction is negative.</summary>
    public uint NegativeX, NegativeY, NegativeZ;

    /// <summary>Bits of the active lanes.</summary>
    public uint Active;

    /// <summary>Tells whether all active lanes agree in all signs of their directions.</summary>
    public readonly bool SharesSigns =>
        (NegativeX == 0 || NegativeX == Active) && (NegativeY == 0 || NegativeY == Active) && (NegativeZ == 0 || NegativeZ == Active);

    /// <summary>Bits of the axes along which the second child is the nearer one, by the first active lane.</summary>
    public readonly int SecondChildFirst
    {
        get
        {
            int lane = BitOperations.TrailingZeroCount(Active);
            return (int)(((NegativeX >> lane) & 1) | (((NegativeY >> lane) & 1) << 1) | (((NegativeZ >> lane) & 1) << 2));
        }
    }

    /// <summary>Prepares rays.</summary>
    /// <param name="tree">The tree.</param>
    /// <param name="ray">The rays, in the tree's space.</param>
    /// <param name="limit">Largest ray parameters; becomes -1 where the lane is off (not above 0, or the ray is not finite or has no direction).</param>
    /// <param name="toFloat">Factor from ray parameters to those of boxes.</param>
    public static BvhRay<R, F, I> Prepare(Bvh tree, in RayLanes<R> ray, ref R limit, out R toFloat)
    {
        R x = R.Abs(ray.DirectionX), y = R.Abs(ray.DirectionY), z = R.Abs(ray.DirectionZ);
        R largest = R.Max(R.Max(x, y), z);
        R sum = R.Abs(ray.OriginX) + R.Abs(ray.OriginY) + R.Abs(ray.OriginZ);
        R active = R.Less(R.Zero, limit) & R.Less(R.Zero, largest) & R.Less(sum + (x + y + z), R.Of(double.PositiveInfinity));
        limit = R.Select(active, limit, R.Of(-1));
        toFloat = R.Select(active, largest, R.Of(1));
        R size = (sum + R.Of(tree.Size)) * R.Of(R.IsSingle ? 9.5367431640625e-7 : 1.7763568394002505e-15);
        BvhRay<R, F, I> result = default;
        result.Active = R.Bits(active);
        result.X = SlabOf(ray.OriginX - R.Of(tree.CenterX), ray.DirectionX, toFloat, size, tree.SizeX, active, out result.NegativeX);
        result.Y = SlabOf(ray.OriginY - R.Of(tree.CenterY), ray.DirectionY, toFloat, size, tree.SizeY, active, out result.NegativeY);
        result.Z = SlabOf(ray.OriginZ - R.Of(tree.CenterZ), ray.DirectionZ, toFloat, size, tree.SizeZ, active, out result.NegativeZ);
        return result;
    }

    /// <summary>A ray parameter's limit in the units of boxes, rounded up; -1 for lanes that are off.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static F LimitOf(R limit, R toFloat)
    {
        F above = R.ToSingle(limit * toFloat) * F.Of(1 + 2.384185791015625e-7);
        return F.Select(R.MaskToSingle(R.Less(R.Zero, limit)), above, F.Of(-1));
    }

    private static BvhSlab<F> SlabOf(R origin, R direction, R largest, R widening, double boxSize, R active, out uint negative)
    {
        R isNegative = R.Less(direction, R.Zero);
        R steepest = R.Select(isNegative, R.Of(-LargestInverse), R.Of(LargestInverse));
        R isSteep = R.LessOrEqual(R.Abs(direction), largest * R.Of(SmallestSlope));
        R inverse = R.Select(active, R.Select(isSteep, steepest, largest / direction), R.Of(1));
        R offset = R.Select(active, -origin * inverse, R.Zero);
        R width = R.Fma(R.Abs(origin) + R.Of(boxSize), R.Of(4.76837158203125e-7), widening) * R.Abs(inverse);
        width = R.Select(active, width, R.Zero);
        negative = R.Bits(isNegative & active);
        BvhSlab<F> slab;
        slab.Inverse = R.ToSingle(inverse);
        slab.Near = R.ToSingle(offset - width);
        slab.Far = R.ToSingle(offset + width);
        return slab;
    }
}
