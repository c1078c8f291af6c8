using System.Numerics;
using System.Runtime.CompilerServices;

namespace LabRaytracer;

/// <summary>Rays that share the signs of their directions against eight boxes at a time: by the least and the largest of each of their numbers.</summary>
/// <remarks>
/// The planes of a box at coordinate c are met at (c - o) / d. With o' near all origins, c - o' times any 1 / d lies between its products with the least and the largest 1 / d,
/// and o' - o times 1 / d between its own least and largest values; rounding keeps the order of both. The margin is twice that of <see cref="BvhRay{R, F, I}"/>,
/// and 8 u (|o'| + b) more, with its u and b: the rounding of c - o', and once more that of its product.
/// </remarks>
internal readonly unsafe struct BvhBundle : IBvhWideTest
{
    private readonly Float8 _originX, _originY, _originZ;
    private readonly Float8 _leastX, _leastY, _leastZ, _largestX, _largestY, _largestZ;
    private readonly Float8 _earlyX, _earlyY, _earlyZ, _lateX, _lateY, _lateZ;
    private readonly int _nearX, _nearY, _nearZ;

    private BvhBundle(in Axis x, in Axis y, in Axis z)
    {
        (_originX, _leastX, _largestX, _earlyX, _lateX) = (Float8.Of(x.Origin), Float8.Of(x.Least), Float8.Of(x.Largest), Float8.Of(x.Early), Float8.Of(x.Late));
        (_originY, _leastY, _largestY, _earlyY, _lateY) = (Float8.Of(y.Origin), Float8.Of(y.Least), Float8.Of(y.Largest), Float8.Of(y.Early), Float8.Of(y.Late));
        (_originZ, _leastZ, _largestZ, _earlyZ, _lateZ) = (Float8.Of(z.Origin), Float8.Of(z.Least), Float8.Of(z.Largest), Float8.Of(z.Early), Float8.Of(z.Late));
        _nearX = x.Largest < 0 ? BvhWideRay.Across : 0;
        _nearY = BvhWideNode.Width + (y.Largest < 0 ? BvhWideRay.Across : 0);
        _nearZ = (2 * BvhWideNode.Width) + (z.Largest < 0 ? BvhWideRay.Across : 0);
    }

    /// <summary>Bounds prepared rays, of which at least one is active.</summary>
    [MethodImpl(MethodImplOptions.NoInlining)]
    public static void Bound<R, F, I>(in BvhFrame tree, in RayLanes<R> ray, in BvhRay<R, F, I> rays, out BvhBundle bundle)
        where R : unmanaged, ILane<R, F, I>
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I>
    {
        Axis x = AxisOf(ray.OriginX - R.Of(tree.CenterX), tree.SizeX, rays.X, rays.Active);
        Axis y = AxisOf(ray.OriginY - R.Of(tree.CenterY), tree.SizeY, rays.Y, rays.Active);
        Axis z = AxisOf(ray.OriginZ - R.Of(tree.CenterZ), tree.SizeZ, rays.Z, rays.Active);
        bundle = new BvhBundle(x, y, z);

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        static Axis AxisOf(R origin, float boxSize, in BvhSlab<F> slab, uint active)
        {
            float first = (float)Lane.Take(&origin, BitOperations.TrailingZeroCount(active));
            F offset = R.ToSingle(R.Of(first) - origin) * slab.Inverse;
            F width = F.Fma(F.Abs(slab.Inverse), F.Of((Math.Abs(first) + (double)boxSize) * 4.76837158203125e-7), slab.Far - slab.Near);
            F early = offset - width, late = offset + width, inverse = slab.Inverse;
            float* inverses = (float*)&inverse, earlies = (float*)&early, lates = (float*)&late;
            Axis axis = new() { Origin = first, Least = float.MaxValue, Largest = float.MinValue, Early = float.MaxValue, Late = float.MinValue };
            for (; active != 0; active &= active - 1)
            {
                int lane = BitOperations.TrailingZeroCount(active);
                axis.Least = inverses[lane] < axis.Least ? inverses[lane] : axis.Least;
                axis.Largest = inverses[lane] > axis.Largest ? inverses[lane] : axis.Largest;
                axis.Early = earlies[lane] < axis.Early ? earlies[lane] : axis.Early;
                axis.Late = lates[lane] > axis.Late ? lates[lane] : axis.Late;
            }

            return axis;
        }
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public uint Meet(float* planes, float limit, out Float8 near)
    {
        const int Across = BvhWideRay.Across, Axis = BvhWideNode.Width;
        Float8 nearX = Early(planes + _nearX, _originX, _leastX, _largestX, _earlyX);
        Float8 nearY = Early(planes + _nearY, _originY, _leastY, _largestY, _earlyY);
        Float8 nearZ = Early(planes + _nearZ, _originZ, _leastZ, _largestZ, _earlyZ);
        Float8 farX = Late(planes + (Across - _nearX), _originX, _leastX, _largestX, _lateX);
        Float8 farY = Late(planes + (Across + (2 * Axis) - _nearY), _originY, _leastY, _largestY, _lateY);
        Float8 farZ = Late(planes + (Across + (4 * Axis) - _nearZ), _originZ, _leastZ, _largestZ, _lateZ);
        near = Float8.Max(Float8.Max(nearX, nearY), Float8.Max(nearZ, Float8.Zero));
        Float8 far = Float8.Min(Float8.Min(farX, farY), Float8.Min(farZ, Float8.Of(limit)));
        return Float8.Bits(Float8.LessOrEqual(near, far));
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Float8 Early(float* planes, Float8 origin, Float8 least, Float8 largest, Float8 early)
    {
        Float8 way = *(Float8*)planes - origin;
        return Float8.Min(Float8.Fma(way, least, early), Float8.Fma(way, largest, early));
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Float8 Late(float* planes, Float8 origin, Float8 least, Float8 largest, Float8 late)
    {
        Float8 way = *(Float8*)planes - origin;
        return Float8.Max(Float8.Fma(way, least, late), Float8.Fma(way, largest, late));
    }

    private struct Axis
    {
        public float Origin, Least, Largest, Early, Late;
    }
}
