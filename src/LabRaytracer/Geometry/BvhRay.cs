using System.Numerics;
using System.Runtime.CompilerServices;

namespace LabRaytracer;

/// <summary>Rays prepared for boxes in floats, so that no box is missed that holds a hit.</summary>
/// <remarks>
/// <para>With m the power of two below the largest component of a direction, the ray parameter in floats is t m, and the slopes are m / d, of magnitude 1/2 to 2^50:
/// a smaller component counts as 2^-50 m, which moves the ray by less than 2^-50 of its way through the tree's box.</para>
/// <para>Let o be an origin's coordinate and b the largest coordinate of the tree's box, both relative to the tree's centre, u = 2^-24, and e the unit roundoff of the
/// lanes (2^-53, or u). The float plane at c is wrong by at most u (3 |c| + 6 |o|) of length along its axis: two roundings of the slope and one of the fma; for the
/// origin also its own, the product's and the margin's. The triangle test may find a point up to 8 e D beside the exact ray, with D the sum of all coordinates of ray
/// and box: each sheared vertex is wrong by up to 4 e D, and weights wrong by 2 e move a mean of vertices that lie within D. Every plane is moved outward by
/// w = 8 u (|o| + b) + 16 e D, which covers all of it, the 2^-50 above and the rounding of w itself.</para>
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
    private const double LeastSingle = 1e-30;
    private const double LeastDouble = 1e-300;

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
        R largest = R.Max(R.Max(R.Abs(ray.DirectionX), R.Abs(ray.DirectionY)), R.Abs(ray.DirectionZ));
        R sum = R.Abs(ray.OriginX) + R.Abs(ray.OriginY) + R.Abs(ray.OriginZ);
        R active = R.Less(R.Zero, limit) & R.LessOrEqual(R.Of(R.IsSingle ? LeastSingle : LeastDouble), largest)
            & R.Less(sum, R.Of(double.PositiveInfinity)) & R.Less(largest, R.Of(R.IsSingle ? 1 / LeastSingle : 1 / LeastDouble));
        limit = R.Select(active, limit, R.Of(-1));
        R exponent = R.Exponent(R.Select(active, largest, R.Of(1)));
        toFloat = R.PowerOfTwo(exponent);
        R scale = R.PowerOfTwo(-exponent);
        F width = R.ToSingle((sum + R.Of(tree.Size)) * R.Of(R.IsSingle ? 9.5367431640625e-7 : 1.7763568394002505e-15));
        F isActive = R.MaskToSingle(active);
        BvhRay<R, F, I> result = default;
        result.Active = R.Bits(active);
        result.X = SlabOf(R.ToSingle(ray.OriginX - R.Of(tree.CenterX)), R.ToSingle(ray.DirectionX * scale), width, tree.SizeX, isActive, out result.NegativeX);
        result.Y = SlabOf(R.ToSingle(ray.OriginY - R.Of(tree.CenterY)), R.ToSingle(ray.DirectionY * scale), width, tree.SizeY, isActive, out result.NegativeY);
        result.Z = SlabOf(R.ToSingle(ray.OriginZ - R.Of(tree.CenterZ)), R.ToSingle(ray.DirectionZ * scale), width, tree.SizeZ, isActive, out result.NegativeZ);
        return result;
    }

    /// <summary>A ray parameter's limit in the units of boxes, rounded up; -1 for lanes that are off.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static F LimitOf(R limit, R toFloat)
    {
        F above = R.ToSingle(limit * toFloat) * F.Of(1 + 2.384185791015625e-7);
        return F.Select(R.MaskToSingle(R.Less(R.Zero, limit)), above, F.Of(-1));
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static BvhSlab<F> SlabOf(F origin, F direction, F widening, double boxSize, F active, out uint negative)
    {
        F isNegative = F.Less(direction, F.Zero);
        F least = F.Select(isNegative, F.Of(-SmallestSlope), F.Of(SmallestSlope));
        F slope = F.Select(F.Less(F.Abs(direction), F.Of(SmallestSlope)), least, direction);
        F inverse = F.Of(1) / F.Select(active, slope, F.Of(1));
        F offset = -origin * inverse & active;
        F width = F.Fma(F.Abs(origin) + F.Of(boxSize), F.Of(4.76837158203125e-7), widening) * F.Abs(inverse) & active;
        negative = F.Bits(isNegative & active);
        BvhSlab<F> slab;
        slab.Inverse = inverse;
        slab.Near = offset - width;
        slab.Far = offset + width;
        return slab;
    }
}
