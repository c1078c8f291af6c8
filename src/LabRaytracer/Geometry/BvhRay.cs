using System.Numerics;
using System.Runtime.CompilerServices;

namespace LabRaytracer;

/// <summary>Rays prepared for boxes in floats, so that no box is missed that holds a hit.</summary>
/// <remarks>
/// <para>With m the power of two below the largest component of a direction (1 if all of them are near 1), the ray parameter in floats is t m, and the slopes are m / d, of magnitude 1/2 to 2^50:
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

    /// <summary>Largest ray parameters; -1 where the lane is off (not above 0, or the ray is not finite or has no direction).</summary>
    public R Limit;

    /// <summary>Factor from ray parameters to those of boxes.</summary>
    public R ToFloat;

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
    /// <param name="tree">Where the tree is.</param>
    /// <param name="ray">The rays, in the tree's space.</param>
    /// <param name="limit">Largest ray parameters.</param>
    /// <param name="result">The prepared rays.</param>
    public static void Prepare(in BvhFrame tree, in RayLanes<R> ray, in R limit, out BvhRay<R, F, I> result)
    {
        F dx = R.ToSingle(ray.DirectionX), dy = R.ToSingle(ray.DirectionY), dz = R.ToSingle(ray.DirectionZ);
        F largest = F.Max(F.Max(F.Abs(dx), F.Abs(dy)), F.Abs(dz));
        result = default;
        result.ToFloat = R.Of(1);
        F isUnit = F.LessOrEqual(F.Of(0.25), largest) & F.LessOrEqual(largest, F.Of(2));
        if (!F.All(isUnit))
        {
            Rescale(ray, out isUnit, out result.ToFloat, out dx, out dy, out dz);
        }

        F sum = F.Abs(R.ToSingle(ray.OriginX)) + F.Abs(R.ToSingle(ray.OriginY)) + F.Abs(R.ToSingle(ray.OriginZ));
        F active = R.MaskToSingle(R.Less(R.Zero, limit)) & isUnit & F.Less(sum, F.Of(double.PositiveInfinity));
        result.Limit = R.Select(R.MaskFromSingle(active), limit, R.Of(-1));
        F width = (sum + F.Of(tree.Size)) * F.Of(R.IsSingle ? 9.5367431640625e-7 : 1.7763568394002505e-15);
        result.Active = F.Bits(active);
        result.X = SlabOf(R.ToSingle(ray.OriginX - R.Of(tree.CenterX)), dx, width, tree.SizeX, active, out result.NegativeX);
        result.Y = SlabOf(R.ToSingle(ray.OriginY - R.Of(tree.CenterY)), dy, width, tree.SizeY, active, out result.NegativeY);
        result.Z = SlabOf(R.ToSingle(ray.OriginZ - R.Of(tree.CenterZ)), dz, width, tree.SizeZ, active, out result.NegativeZ);
    }

    /// <summary>Directions of any length, brought to a largest component in [1, 2) by a power of two; the mask is false where there is no direction.</summary>
    [MethodImpl(MethodImplOptions.NoInlining)]
    private static void Rescale(in RayLanes<R> ray, out F mask, out R toFloat, out F x, out F y, out F z)
    {
        R largest = R.Max(R.Max(R.Abs(ray.DirectionX), R.Abs(ray.DirectionY)), R.Abs(ray.DirectionZ));
        R isUsable = R.LessOrEqual(R.Of(R.IsSingle ? LeastSingle : LeastDouble), largest) & R.Less(largest, R.Of(R.IsSingle ? 1 / LeastSingle : 1 / LeastDouble));
        R exponent = R.Exponent(R.Select(isUsable, largest, R.Of(1)));
        toFloat = R.PowerOfTwo(exponent);
        R scale = R.PowerOfTwo(-exponent);
        x = R.ToSingle(ray.DirectionX * scale);
        y = R.ToSingle(ray.DirectionY * scale);
        z = R.ToSingle(ray.DirectionZ * scale);
        mask = R.MaskToSingle(isUsable);
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
