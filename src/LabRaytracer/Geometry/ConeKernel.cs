using System.Runtime.CompilerServices;

namespace LabRaytracer;

/// <summary>The formulas of <see cref="Cone"/>: apex x, y, z, radius of the base, height, and 1 for a base or 0 for none.</summary>
[SkipLocalsInit]
internal readonly struct ConeKernel : IShapeKernel
{
    private const int ApexX = 0, ApexY = 1, ApexZ = 2, Radius = 3, Height = 4, HasBase = 5;

    public static int ParameterCount => 6;

    public static bool IsConvex => true;

    public static bool IsCurved => true;

    public static void Describe(Shape shape, Transform transform, Span<double> numbers)
    {
        Cone cone = (Cone)shape;
        numbers[ApexX] = cone.Center.X;
        numbers[ApexY] = cone.Center.Y + (cone.Height / 2);
        numbers[ApexZ] = cone.Center.Z;
        numbers[Radius] = cone.Radius;
        numbers[Height] = cone.Height;
        numbers[HasBase] = cone.Caps == ConeCaps.Closed ? 1 : 0;
    }

    /// <remarks>Where the silhouette, the rim, the apex or the origin is within a few units of the last place of deciding otherwise, twice the digits decide.</remarks>
    [MethodImpl(MethodImplOptions.NoInlining)]
    public static R Intersect<R, P>(in P shape, in RayLanes<R> ray, out R t)
        where R : unmanaged, IReal<R>
        where P : struct, IParameters<R>
    {
        CentredRay<R>.Of(ray, shape, ApexX, out CentredRay<R> centred);
        ConeChoice<R> choice = new(centred, shape[Radius], shape[Height], shape[HasBase]);
        t = centred.K + choice.Along;
        R hit = choice.IsHit;
        if (R.Any(choice.IsClose))
        {
            PreciseConeHit<R> precise = Precise(shape, ray, centred.K);
            t = R.Select(choice.IsClose, precise.T, t);
            hit = R.Select(choice.IsClose, precise.IsHit, hit);
        }

        return hit;
    }

    /// <remarks>The same formulas as in <see cref="Surface"/>, without the surface.</remarks>
    [MethodImpl(MethodImplOptions.NoInlining)]
    public static R Refine<R, P>(in P shape, in RayLanes<R> ray, R t)
        where R : unmanaged, IReal<R>
        where P : struct, IParameters<R>
    {
        CentredRay<R>.Of(ray, shape, ApexX, out CentredRay<R> centred);
        ConeChoice<R> choice = new(centred, shape[Radius], shape[Height], shape[HasBase]);
        if (R.Any(choice.IsRough))
        {
            PreciseConeHit<R> precise = Precise(shape, ray, centred.K);
            t = R.Select(choice.IsRough & precise.IsHit, precise.T, t);
        }

        return t;
    }

    /// <remarks>On the side the local point is put back along the radius, y stays; on the base y is exactly -1.</remarks>
    [MethodImpl(MethodImplOptions.NoInlining)]
    public static void Surface<R, P>(in P shape, in RayLanes<R> ray, ref R t, out SurfaceLanes<R> s)
        where R : unmanaged, IReal<R>
        where P : struct, IParameters<R>
    {
        R radius = shape[Radius], height = shape[Height];
        CentredRay<R>.Of(ray, shape, ApexX, out CentredRay<R> centred);
        ConeChoice<R> choice = new(centred, radius, height, shape[HasBase]);
        R isBase = choice.IsBase;
        R x = R.Fma(choice.Along, centred.DirectionX, centred.X);
        R y = R.Fma(choice.Along, centred.DirectionY, centred.Y);
        R z = R.Fma(choice.Along, centred.DirectionZ, centred.Z);
        if (R.Any(choice.IsRough))
        {
            PreciseConeHit<R> precise = Precise(shape, ray, centred.K);
            R isRough = choice.IsRough & precise.IsHit;
            t = R.Select(isRough, precise.T, t);
            x = R.Select(isRough, precise.X, x);
            y = R.Select(isRough, precise.Y, y);
            z = R.Select(isRough, precise.Z, z);
            isBase = R.Select(isRough, precise.IsBase, isBase);
        }

        PutBack(isBase, radius, height, x, y, z, out s);
        s.PointX = R.Fma(radius, s.LocalX, shape[ApexX]);
        s.PointY = shape[ApexY] + R.Select(isBase, -height, y);
        s.PointZ = R.Fma(radius, s.LocalZ, shape[ApexZ]);
        s.Slack = Lane.Slack(R.Abs(shape[ApexX]) + R.Abs(shape[ApexY]) + R.Abs(shape[ApexZ]) + radius + height);
    }

    /// <summary>Local point and normals of points near the surface, given relative to the apex.</summary>
    [MethodImpl(MethodImplOptions.NoInlining)]
    private static void PutBack<R>(in R isBase, in R radius, in R height, in R x, in R y, in R z, out SurfaceLanes<R> s)
        where R : unmanaged, IReal<R>
    {
        R one = R.Of(1), distance = R.Sqrt(R.Fma(x, x, z * z));
        R isAxis = R.Equal(distance, R.Zero);
        R toUnit = one / R.Select(isAxis, one, distance);
        R sin = x * toUnit, cos = R.Select(isAxis, one, z * toUnit);
        R below = -y / height;

        // The normal leans up by the slope of the side, which is radius / height here and 1 / 2 in the local form.
        R length = one / R.Sqrt(R.Fma(radius, radius, height * height));
        R outward = ~isBase & (height * length), upward = R.Select(isBase, -one, radius * length);
        s = default;
        s.LocalX = R.Select(isBase, x / radius, sin * below);
        s.LocalY = R.Select(isBase, -one, R.Fma(below, R.Of(-2), one));
        s.LocalZ = R.Select(isBase, z / radius, cos * below);
        s.NormalX = s.ShadingX = sin * outward;
        s.NormalY = s.ShadingY = upward;
        s.NormalZ = s.ShadingZ = cos * outward;
        R localOutward = ~isBase & R.Of(0.89442719099991586);
        s.LocalNormalX = sin * localOutward;
        s.LocalNormalY = R.Select(isBase, -one, R.Of(0.44721359549995793));
        s.LocalNormalZ = cos * localOutward;
    }

    [MethodImpl(MethodImplOptions.NoInlining)]
    private static PreciseConeHit<R> Precise<R, P>(in P shape, in RayLanes<R> ray, in R k)
        where R : unmanaged, IReal<R>
        where P : struct, IParameters<R> =>
        new(ray, new PreciseLine<R>(ray, shape[ApexX], shape[ApexY], shape[ApexZ], k), shape[Radius], shape[Height], shape[HasBase]);

    public static void LocalFrame<R, P>(in P shape, out LinearLanes<R> frame)
        where R : unmanaged, IReal<R>
        where P : struct, IParameters<R>
    {
        R scale = R.Of(1) / shape[Radius];
        frame = LinearLanes<R>.Scaling(scale, R.Of(2) / shape[Height], scale);
    }

    /// <remarks>(x, rho / 2, z) on the side; nothing bends on the base, where y is exactly -1.</remarks>
    public static void BendNormal<R, P>(in P shape, R x, R y, R z, R stepX, R stepY, R stepZ, out NormalLanes<R> normal)
        where R : unmanaged, IReal<R>
        where P : struct, IParameters<R>
    {
        R isSide = ~R.Equal(y, R.Of(-1)), half = R.Of(0.5);
        R distance = R.Sqrt(R.Fma(x, x, z * z));
        R change = R.Fma(x, stepX, z * stepZ) / R.Select(R.Less(R.Zero, distance), distance, R.Of(1));
        normal = new NormalLanes<R>
        {
            X = isSide & x,
            Y = R.Select(isSide, distance * half, R.Of(-1)),
            Z = isSide & z,
            StepX = isSide & stepX,
            StepY = isSide & (change * half),
            StepZ = isSide & stepZ,
        };
    }
}
