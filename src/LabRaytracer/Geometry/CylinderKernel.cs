using System.Numerics;
using System.Runtime.CompilerServices;

namespace LabRaytracer;

/// <summary>The formulas of <see cref="Cylinder"/>: centre x, y, z, radius and half the height.</summary>
[SkipLocalsInit]
internal readonly struct CylinderKernel : IShapeKernel
{
    private const int CenterX = 0, CenterY = 1, CenterZ = 2, Radius = 3, HalfHeight = 4;

    public static int ParameterCount => 5;

    public static bool IsConvex => true;

    public static bool IsCurved => true;

    public static void Describe(Shape shape, Transform transform, Span<double> numbers)
    {
        Cylinder cylinder = (Cylinder)shape;
        numbers[CenterX] = cylinder.Center.X;
        numbers[CenterY] = cylinder.Center.Y;
        numbers[CenterZ] = cylinder.Center.Z;
        numbers[Radius] = cylinder.Radius;
        numbers[HalfHeight] = cylinder.Height / 2;
    }

    /// <remarks>Where the silhouette, an end or the origin is within a few units of the last place of deciding otherwise, twice the digits decide.</remarks>
    [MethodImpl(MethodImplOptions.NoInlining)]
    public static R Intersect<R, P>(in P shape, in RayLanes<R> ray, out R t)
        where R : unmanaged, IReal<R>
        where P : struct, IParameters<R>
    {
        CentredRay<R>.Of(ray, shape, CenterX, out CentredRay<R> centred);
        R along = Choose(centred, shape[Radius], shape[HalfHeight], out R hit, out R isClose, out _);
        t = centred.K + along;
        return R.Any(isClose) ? Decide(shape, ray, centred.K, isClose, hit, ref t) : hit;
    }

    /// <remarks>The same formulas as in <see cref="Surface"/>, without the surface.</remarks>
    [MethodImpl(MethodImplOptions.NoInlining)]
    public static R Refine<R, P>(in P shape, in RayLanes<R> ray, R t)
        where R : unmanaged, IReal<R>
        where P : struct, IParameters<R>
    {
        CentredRay<R>.Of(ray, shape, CenterX, out CentredRay<R> centred);
        Choose(centred, shape[Radius], shape[HalfHeight], out _, out _, out R isRough);
        return R.Any(isRough) ? R.Select(isRough, Precise(shape, ray, centred.K).T, t) : t;
    }

    /// <remarks>
    /// The local point is put back onto the mantle along its normal; y stays. Hits that graze the mantle or run along the axis are computed with twice the digits:
    /// t within 2.5 units of 2^-53, the point within 3 such units of the radius from the mantle.
    /// </remarks>
    [MethodImpl(MethodImplOptions.NoInlining)]
    public static void Surface<R, P>(in P shape, in RayLanes<R> ray, ref R t, out SurfaceLanes<R> s)
        where R : unmanaged, IReal<R>
        where P : struct, IParameters<R>
    {
        R radius = shape[Radius], halfHeight = shape[HalfHeight];
        CentredRay<R>.Of(ray, shape, CenterX, out CentredRay<R> centred);
        R along = Choose(centred, radius, halfHeight, out _, out _, out R isRough);
        R x = R.Fma(along, centred.DirectionX, centred.X);
        R y = R.Fma(along, centred.DirectionY, centred.Y);
        R z = R.Fma(along, centred.DirectionZ, centred.Z);
        if (R.Any(isRough))
        {
            PreciseCylinderHit<R> precise = Precise(shape, ray, centred.K);
            t = R.Select(isRough, precise.T, t);
            x = R.Select(isRough, precise.X, x);
            y = R.Select(isRough, precise.Y, y);
            z = R.Select(isRough, precise.Z, z);
        }

        s = Place(shape, x, y, z);
    }

    /// <remarks>With twice the digits; where those do not decide how t is rounded, by exact arithmetic.</remarks>
    [MethodImpl(MethodImplOptions.NoInlining)]
    public static void Sharpen<R, P>(in P shape, in RayLanes<R> ray, ref R t, ref SurfaceLanes<R> s)
        where R : unmanaged, IReal<R>
        where P : struct, IParameters<R>
    {
        CentredRay<R>.Of(ray, shape, CenterX, out CentredRay<R> centred);
        PreciseCylinderHit<R> precise = Precise(shape, ray, centred.K);
        t = R.Select(precise.IsHit, precise.T, t);
        for (uint open = R.Bits(~precise.IsExact); open != 0; open &= open - 1)
        {
            int lane = BitOperations.TrailingZeroCount(open);
            Point3D center = new(R.Get(shape[CenterX], lane), R.Get(shape[CenterY], lane), R.Get(shape[CenterZ], lane));
            double exact = ExactDistance.OfCylinder(RoundedParameter.Lane(ray, lane), center, R.Get(shape[Radius], lane), R.Get(shape[HalfHeight], lane));
            t = RoundedParameter.Replace(t, lane, exact);
        }

        s = SurfaceLanes.Select(precise.IsHit, Place(shape, precise.X, precise.Y, precise.Z), s);
    }

    /// <summary>The surface at a point relative to the centre, which is put back onto the mantle.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static SurfaceLanes<R> Place<R, P>(in P shape, R x, R y, R z)
        where R : unmanaged, IReal<R>
        where P : struct, IParameters<R>
    {
        R radius = shape[Radius], halfHeight = shape[HalfHeight];
        R toUnit = R.Of(1) / R.Sqrt(R.Fma(x, x, z * z));
        SurfaceLanes<R> s = default;
        s.LocalX = x * toUnit;
        s.LocalY = y / halfHeight;
        s.LocalZ = z * toUnit;
        s.NormalX = s.ShadingX = s.LocalNormalX = s.LocalX;
        s.NormalZ = s.ShadingZ = s.LocalNormalZ = s.LocalZ;
        s.PointX = R.Fma(radius, s.LocalX, shape[CenterX]);
        s.PointY = shape[CenterY] + y;
        s.PointZ = R.Fma(radius, s.LocalZ, shape[CenterZ]);
        s.Slack = Lane.Slack(R.Abs(shape[CenterX]) + R.Abs(shape[CenterY]) + R.Abs(shape[CenterZ]) + radius + halfHeight);
        return s;
    }

    /// <summary>Steps s from the nearest point l to the nearest hit ahead between the ends.</summary>
    /// <param name="ray">Rays from their points nearest to the centre.</param>
    /// <param name="radius">Radius.</param>
    /// <param name="halfHeight">Half the height.</param>
    /// <param name="hit">Mask of hits.</param>
    /// <param name="isClose">Mask: the decision is too close to be certain.</param>
    /// <param name="isRough">Mask: the error of s shows in t or in the point; or the decision was close.</param>
    /// <remarks>
    /// a s^2 + 2 b s + c = 0 with a = d.d, b = l.d, c = l.l - r^2, all in (x, z). The discriminant b^2 - a c is a r^2 - (l x d)^2, which does not cancel;
    /// one root is q / a, the other c / q, so that rays along the axis (a near 0) keep the root that matters. s is wrong by a few units of r^2 / root.
    /// </remarks>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static R Choose<R>(in CentredRay<R> ray, R radius, R halfHeight, out R hit, out R isClose, out R isRough)
        where R : unmanaged, IReal<R>
    {
        R dx = ray.DirectionX, dz = ray.DirectionZ;
        R a = R.Fma(dx, dx, dz * dz);
        R b = R.Fma(ray.X, dx, ray.Z * dz);
        R square = radius * radius;
        R c = -R.Fma(radius, radius, -R.Fma(ray.X, ray.X, ray.Z * ray.Z));
        R aside = Compensated.DifferenceOfProducts(ray.Z, dx, ray.X, dz);
        R discriminant = R.Fma(a, square, -(aside * aside));
        R root = R.Sqrt(R.Max(discriminant, R.Zero));
        R q = -(b + R.Select(R.Less(b, R.Zero), -root, root));
        R byA = q / a;
        R byQ = c / q;

        // Where q = 0 (a tangent at l itself) both roots are 0 / a; c / 0 is no number and loses every comparison.
        R near = R.Min(byQ, byA);
        R far = R.Max(byQ, byA);
        R unit = R.Of(R.IsSingle ? 16.0 / (1 << 24) : 16.0 / (1L << 53));
        R uncertainty = unit * square / root;
        R isNear = IsAhead(ray, near, halfHeight, unit, uncertainty, out R nearIsClose);
        R isFar = IsAhead(ray, far, halfHeight, unit, uncertainty, out R farIsClose);
        hit = R.LessOrEqual(R.Zero, discriminant) & (isNear | isFar);
        isClose = R.LessOrEqual(R.Abs(discriminant), unit * a * square) | (R.Less(R.Zero, discriminant) & (nearIsClose | farIsClose));
        R along = R.Select(isNear, near, far);
        R size = R.Of(8) * R.Min(radius, halfHeight) * R.Sqrt(ray.InverseLengthSquared);

        // The error of s is up to 4 units of r^2 / root, that of t 2.5 units at most. From within one chord of the hit, it is a larger part of t.
        R t = R.Abs(ray.K + along);
        R isNearby = R.Less(a * t, R.Of(2) * root);
        isRough = ~R.LessOrEqual(square, root * R.Min(R.Select(isNearby, R.Of(0.3125), R.Of(0.625)) * t, size)) | isClose;
        return along;
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static R IsAhead<R>(in CentredRay<R> ray, R along, R halfHeight, R unit, R uncertainty, out R isClose)
        where R : unmanaged, IReal<R>
    {
        R t = ray.K + along;
        R y = R.Abs(R.Fma(along, ray.DirectionY, ray.Y));
        R slack = R.Fma(uncertainty, R.Abs(ray.DirectionY), unit * (halfHeight + R.Abs(ray.Y)));
        isClose = R.LessOrEqual(R.Abs(y - halfHeight), slack) | R.LessOrEqual(R.Abs(t), R.Fma(unit, R.Abs(ray.K), uncertainty));
        return R.Less(R.Zero, t) & R.Less(t, R.Of(double.PositiveInfinity)) & R.LessOrEqual(y, halfHeight);
    }

    /// <summary>Hit or miss, and t, of the lanes of a mask with twice the digits; the others stay.</summary>
    [MethodImpl(MethodImplOptions.NoInlining)]
    private static R Decide<R, P>(in P shape, in RayLanes<R> ray, R k, R mask, R hit, ref R t)
        where R : unmanaged, IReal<R>
        where P : struct, IParameters<R>
    {
        PreciseCylinderHit<R> precise = Precise(shape, ray, k);
        t = R.Select(mask, precise.T, t);
        return R.Select(mask, precise.IsHit, hit);
    }

    [MethodImpl(MethodImplOptions.NoInlining)]
    private static PreciseCylinderHit<R> Precise<R, P>(in P shape, in RayLanes<R> ray, R k)
        where R : unmanaged, IReal<R>
        where P : struct, IParameters<R> =>
        new(ray, shape[CenterX], shape[CenterY], shape[CenterZ], shape[Radius], shape[HalfHeight], k);

    public static void LocalFrame<R, P>(in P shape, out LinearLanes<R> frame)
        where R : unmanaged, IReal<R>
        where P : struct, IParameters<R>
    {
        R scale = R.Of(1) / shape[Radius];
        frame = LinearLanes<R>.Scaling(scale, R.Of(1) / shape[HalfHeight], scale);
    }

    public static void BendNormal<R, P>(in P shape, R x, R y, R z, R stepX, R stepY, R stepZ, out NormalLanes<R> normal)
        where R : unmanaged, IReal<R>
        where P : struct, IParameters<R> =>
        normal = new NormalLanes<R> { X = x, Z = z, StepX = stepX, StepZ = stepZ };
}
