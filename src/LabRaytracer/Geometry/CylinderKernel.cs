using System.Runtime.CompilerServices;

namespace LabRaytracer;

/// <summary>The formulas of <see cref="Cylinder"/>: centre x, y, z, radius and half the height.</summary>
internal readonly struct CylinderKernel : IShapeKernel
{
    private const int CenterX = 0, CenterY = 1, CenterZ = 2, Radius = 3, HalfHeight = 4;

    public static int ParameterCount => 5;

    public static bool IsConvex => true;

    public static void Describe(Shape shape, Transform transform, Span<double> numbers)
    {
        Cylinder cylinder = (Cylinder)shape;
        numbers[CenterX] = cylinder.Center.X;
        numbers[CenterY] = cylinder.Center.Y;
        numbers[CenterZ] = cylinder.Center.Z;
        numbers[Radius] = cylinder.Radius;
        numbers[HalfHeight] = cylinder.Height / 2;
    }

    [MethodImpl(MethodImplOptions.NoInlining)]
    public static R Intersect<R, P>(in P shape, in RayLanes<R> ray, out R t)
        where R : unmanaged, IReal<R>
        where P : struct, IParameters<R>
    {
        CentredRay<R> centred = new(ray, shape[CenterX], shape[CenterY], shape[CenterZ]);
        R along = Choose(centred, shape[Radius], shape[HalfHeight], out R hit);
        t = centred.K + along;
        return hit;
    }

    /// <remarks>The local point is put back onto the mantle along its normal; y stays.</remarks>
    [MethodImpl(MethodImplOptions.NoInlining)]
    public static void Surface<R, P>(in P shape, in RayLanes<R> ray, R t, out SurfaceLanes<R> s)
        where R : unmanaged, IReal<R>
        where P : struct, IParameters<R>
    {
        R radius = shape[Radius], halfHeight = shape[HalfHeight];
        CentredRay<R> centred = new(ray, shape[CenterX], shape[CenterY], shape[CenterZ]);
        R along = Choose(centred, radius, halfHeight, out _);
        R x = R.Fma(along, centred.DirectionX, centred.X);
        R y = R.Fma(along, centred.DirectionY, centred.Y);
        R z = R.Fma(along, centred.DirectionZ, centred.Z);
        R toUnit = R.Of(1) / R.Sqrt(R.Fma(x, x, z * z));
        s = default;
        s.LocalX = x * toUnit;
        s.LocalY = y / halfHeight;
        s.LocalZ = z * toUnit;
        s.NormalX = s.ShadingX = s.LocalNormalX = s.LocalX;
        s.NormalZ = s.ShadingZ = s.LocalNormalZ = s.LocalZ;
        s.PointX = R.Fma(radius, s.LocalX, shape[CenterX]);
        s.PointY = shape[CenterY] + y;
        s.PointZ = R.Fma(radius, s.LocalZ, shape[CenterZ]);
        s.Slack = Lane.Slack(R.Abs(shape[CenterX]) + R.Abs(shape[CenterY]) + R.Abs(shape[CenterZ]) + radius + halfHeight);
    }

    /// <summary>Steps s from the nearest point l to the nearest hit ahead between the ends.</summary>
    /// <remarks>
    /// a s^2 + 2 b s + c = 0 with a = d.d, b = l.d, c = l.l - r^2, all in (x, z). The discriminant b^2 - a c is a r^2 - (l x d)^2, which does not cancel;
    /// one root is q / a, the other c / q, so that rays along the axis (a near 0) keep the root that matters.
    /// </remarks>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static R Choose<R>(in CentredRay<R> ray, R radius, R halfHeight, out R hit)
        where R : unmanaged, IReal<R>
    {
        R dx = ray.DirectionX, dz = ray.DirectionZ;
        R a = R.Fma(dx, dx, dz * dz);
        R b = R.Fma(ray.X, dx, ray.Z * dz);
        R c = -R.Fma(radius, radius, -R.Fma(ray.X, ray.X, ray.Z * ray.Z));
        R aside = Compensated.DifferenceOfProducts(ray.Z, dx, ray.X, dz);
        R discriminant = R.Fma(a, radius * radius, -(aside * aside));
        R root = R.Sqrt(R.Max(discriminant, R.Zero));
        R q = -(b + R.Select(R.Less(b, R.Zero), -root, root));
        R byA = q / a;
        R byQ = c / q;

        // Where q = 0 (a tangent at l itself) both roots are 0 / a; c / 0 is no number and loses every comparison.
        R near = R.Min(byQ, byA);
        R far = R.Max(byQ, byA);
        R isNear = IsAhead(ray, near, halfHeight);
        hit = R.LessOrEqual(R.Zero, discriminant) & (isNear | IsAhead(ray, far, halfHeight));
        return R.Select(isNear, near, far);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static R IsAhead<R>(in CentredRay<R> ray, R along, R halfHeight)
        where R : unmanaged, IReal<R>
    {
        R t = ray.K + along;
        R y = R.Fma(along, ray.DirectionY, ray.Y);
        return R.Less(R.Zero, t) & R.Less(t, R.Of(double.PositiveInfinity)) & R.LessOrEqual(R.Abs(y), halfHeight);
    }
}
