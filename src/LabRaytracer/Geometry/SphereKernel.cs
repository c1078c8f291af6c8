using System.Numerics;
using System.Runtime.CompilerServices;

namespace LabRaytracer;

/// <summary>The formulas of <see cref="Sphere"/>: centre x, y, z and radius.</summary>
[SkipLocalsInit]
internal readonly unsafe partial struct SphereKernel : IShapeKernel
{
    private const int CenterX = 0, CenterY = 1, CenterZ = 2, Radius = 3;

    public static int ParameterCount => 4;

    public static bool IsConvex => true;

    public static bool HasQuickLook => true;

    public static bool IsSmooth => true;

    public static bool IsCurved => true;

    public static void Describe(Shape shape, Transform transform, Span<double> numbers)
    {
        Sphere sphere = (Sphere)shape;
        numbers[CenterX] = sphere.Center.X;
        numbers[CenterY] = sphere.Center.Y;
        numbers[CenterZ] = sphere.Center.Z;
        numbers[Radius] = sphere.Radius;
    }

    /// <remarks>
    /// The ray is cut at its point l nearest to the centre: the discriminant r^2 - l^2 then does not cancel against the distance
    /// (Haines et al., "Precision improvements for ray/sphere intersection", Ray Tracing Gems, 2019).
    /// Where the silhouette or the origin is within a few units of the last place of deciding otherwise, twice the digits decide.
    /// </remarks>
    [MethodImpl(MethodImplOptions.NoInlining)]
    public static R Intersect<R, P>(in P shape, in RayLanes<R> ray, out R t)
        where R : unmanaged, IReal<R>
        where P : struct, IParameters<R>
    {
        CentredRay<R>.Of(ray, shape, CenterX, out CentredRay<R> centred);
        R radius = shape[Radius];
        R discriminant = HalfChord(centred, radius, out R step, out R half);
        R near = centred.K + (step - half);
        R far = centred.K + (step + half);
        t = R.Select(R.Less(R.Zero, near), near, far);
        R hit = R.LessOrEqual(R.Zero, discriminant) & R.Less(R.Zero, t) & R.Less(t, R.Of(double.PositiveInfinity));
        R isClose = IsClose(centred, radius, discriminant, near, far);
        if (R.Any(isClose))
        {
            // Copies: what is given by reference lives in memory all the time.
            R mask = isClose, rough = hit;
            return Decide(shape, ray, centred.K, mask, rough, ref t);
        }

        return hit;
    }

    /// <remarks>The same formulas as in <see cref="Surface"/>, without the surface.</remarks>
    [MethodImpl(MethodImplOptions.NoInlining)]
    public static R Refine<R, P>(in P shape, in RayLanes<R> ray, R t)
        where R : unmanaged, IReal<R>
        where P : struct, IParameters<R>
    {
        CentredRay<R>.Of(ray, shape, CenterX, out CentredRay<R> centred);
        R radius = shape[Radius];
        R discriminant = HalfChord(centred, radius, out R step, out R half);
        R near = centred.K + (step - half), far = centred.K + (step + half);
        R isHardT = IsHardT(centred, radius, near, far, half, IsRough(centred, radius, discriminant, near, far, half), out R isRoughT);
        if (R.Any(isRoughT))
        {
            CompensatedChord<R> chord = new(ray, shape[CenterX], shape[CenterY], shape[CenterZ], radius, centred.K, centred.InverseLengthSquared);
            t = R.Select(isRoughT, chord.T, t);
        }

        if (R.Any(isHardT))
        {
            PreciseSphereHit<R> precise = new(ray, shape[CenterX], shape[CenterY], shape[CenterZ], radius, centred.K);
            t = R.Select(isHardT, precise.T, t);
        }

        return t;
    }

    [MethodImpl(MethodImplOptions.NoInlining)]
    public static void Surface<R, P>(in P shape, in RayLanes<R> ray, ref R t, out SurfaceLanes<R> s)
        where R : unmanaged, IReal<R>
        where P : struct, IParameters<R>
    {
        Reach(shape, ray, SurfaceNeeds.Parameter, ref t, out R x, out R y, out R z);
        Place(shape, x, y, z, out s);
    }

    [MethodImpl(MethodImplOptions.NoInlining)]
    public static uint Smooth<R, P>(in P shape, in RayLanes<R> ray, in R t, in SurfaceColumns<R> to, int packet, SurfaceNeeds needs)
        where R : unmanaged, IReal<R>
        where P : struct, IParameters<R>
    {
        CentredRay<R>.Of(ray, shape, CenterX, out CentredRay<R> centred);
        R isRough = Approach(centred, shape[Radius], t, out R x, out R y, out R z, out R near, out R far, out R half);
        if ((needs & SurfaceNeeds.Parameter) != 0)
        {
            isRough = IsHardT(centred, shape[Radius], near, far, half, isRough, out R isRoughT) | isRoughT;
        }

        Store(shape, x, y, z, to, packet, needs);
        return R.Bits(isRough);
    }

    [MethodImpl(MethodImplOptions.NoInlining)]
    public static void SmoothRough<R, P>(in P shape, in RayLanes<R> ray, ref R t, in SurfaceColumns<R> to, int packet, SurfaceNeeds needs)
        where R : unmanaged, IReal<R>
        where P : struct, IParameters<R>
    {
        Reach(shape, ray, needs, ref t, out R x, out R y, out R z);
        Store(shape, x, y, z, to, packet, needs);
    }

    /// <summary>The surface at a point relative to the centre, into columns.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void Store<R, P>(in P shape, R x, R y, R z, in SurfaceColumns<R> to, int packet, SurfaceNeeds needs)
        where R : unmanaged, IReal<R>
        where P : struct, IParameters<R>
    {
        PositionBatch<R> p = to.Positions;
        to.Slack[packet] = SlackOf<R, P>(shape);
        R toUnit = R.Of(1) / R.Sqrt(Lane.Dot(x, y, z, x, y, z)), radius = shape[Radius];
        StoreAxis(p.WorldX, p.WorldNormalX, p.X, p.NormalX, packet, x * toUnit, radius, shape[CenterX], needs);
        StoreAxis(p.WorldY, p.WorldNormalY, p.Y, p.NormalY, packet, y * toUnit, radius, shape[CenterY], needs);
        StoreAxis(p.WorldZ, p.WorldNormalZ, p.Z, p.NormalZ, packet, z * toUnit, radius, shape[CenterZ], needs);
        if ((needs & SurfaceNeeds.SurfaceCoordinates) != 0)
        {
            p.SurfaceU[packet] = p.SurfaceV[packet] = R.Zero;
        }
    }

    /// <summary>One coordinate of the surface in all its columns.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void StoreAxis<R>(R* point, R* normal, R* local, R* localNormal, int packet, R unit, R radius, R center, SurfaceNeeds needs)
        where R : unmanaged, IReal<R>
    {
        point[packet] = R.Fma(radius, unit, center);
        normal[packet] = unit;
        if ((needs & SurfaceNeeds.LocalPoint) != 0)
        {
            local[packet] = unit;
        }

        if ((needs & SurfaceNeeds.LocalNormal) != 0)
        {
            localNormal[packet] = unit;
        }
    }

    /// <summary>The point relative to the centre, not yet put back onto the sphere.</summary>
    /// <remarks>
    /// It is the nearest point l plus or minus half the chord, never o + t d - c: its error stays at a few ulp of the radius at any distance.
    /// Which end of the chord was hit is decided by the very numbers that decided it in <see cref="Intersect"/>; where those leave a choice, by t.
    /// Grazing hits, where half the chord has lost digits, are computed with twice the digits: t within 2.5 units of 2^-53, the point within 3 such units of the radius.
    /// So is t of rays that start near to their hit, if somebody reads it; points do not need it, except in float lanes.
    /// </remarks>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void Reach<R, P>(in P shape, in RayLanes<R> ray, SurfaceNeeds needs, ref R t, out R x, out R y, out R z)
        where R : unmanaged, IReal<R>
        where P : struct, IParameters<R>
    {
        R radius = shape[Radius];
        CentredRay<R>.Of(ray, shape, CenterX, out CentredRay<R> centred);
        R isRough = Approach(centred, radius, t, out x, out y, out z, out R near, out R far, out R half), isHardT = isRough;
        if ((needs & SurfaceNeeds.Parameter) != 0)
        {
            isHardT = IsHardT(centred, radius, near, far, half, isRough, out R isRoughT);
            if (R.Any(isRoughT))
            {
                CompensatedChord<R> chord = new(ray, shape[CenterX], shape[CenterY], shape[CenterZ], radius, centred.K, centred.InverseLengthSquared);
                t = R.Select(isRoughT, chord.T, t);
            }
        }

        if (R.Any(isHardT))
        {
            PreciseSphereHit<R> precise = new(ray, shape[CenterX], shape[CenterY], shape[CenterZ], radius, centred.K);
            t = R.Select(isHardT, precise.T, t);
            x = R.Select(isRough, precise.X, x);
            y = R.Select(isRough, precise.Y, y);
            z = R.Select(isRough, precise.Z, z);
        }
    }

    /// <summary>The point without the hard digits, and both ends of its chord; returns where those digits are missing.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static R Approach<R>(in CentredRay<R> centred, R radius, R t, out R x, out R y, out R z, out R near, out R far, out R half)
        where R : unmanaged, IReal<R>
    {
        R discriminant = HalfChord(centred, radius, out R step, out half);
        near = centred.K + (step - half);
        far = centred.K + (step + half);
        R isNear = R.Less(R.Zero, near) & R.LessOrEqual(t, centred.K + step);
        R along = step + R.Select(isNear, -half, half);
        x = R.Fma(along, centred.DirectionX, centred.X);
        y = R.Fma(along, centred.DirectionY, centred.Y);
        z = R.Fma(along, centred.DirectionZ, centred.Z);
        return IsRough(centred, radius, discriminant, near, far, half);
    }

    /// <remarks>With twice the digits; where those do not decide how t is rounded, by exact arithmetic.</remarks>
    [MethodImpl(MethodImplOptions.NoInlining)]
    public static void Sharpen<R, P>(in P shape, in RayLanes<R> ray, ref R t, ref SurfaceLanes<R> s)
        where R : unmanaged, IReal<R>
        where P : struct, IParameters<R>
    {
        CentredRay<R>.Of(ray, shape, CenterX, out CentredRay<R> centred);
        PreciseSphereHit<R> precise = new(ray, shape[CenterX], shape[CenterY], shape[CenterZ], shape[Radius], centred.K);
        t = R.Select(precise.IsHit, precise.T, t);
        for (uint open = R.Bits(~precise.IsExact); open != 0; open &= open - 1)
        {
            int lane = BitOperations.TrailingZeroCount(open);
            Point3D center = new(R.Get(shape[CenterX], lane), R.Get(shape[CenterY], lane), R.Get(shape[CenterZ], lane));
            t = RoundedParameter.Replace(t, lane, ExactDistance.OfSphere(RoundedParameter.Lane(ray, lane), center, R.Get(shape[Radius], lane)));
        }

        Place(shape, precise.X, precise.Y, precise.Z, out SurfaceLanes<R> sharp);
        s = SurfaceLanes.Select(precise.IsHit, sharp, s);
    }

    /// <summary>The surface at a point relative to the centre, which is put back onto the sphere.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void Place<R, P>(in P shape, R x, R y, R z, out SurfaceLanes<R> s)
        where R : unmanaged, IReal<R>
        where P : struct, IParameters<R>
    {
        R radius = shape[Radius];
        R toUnit = R.Of(1) / R.Sqrt(Lane.Dot(x, y, z, x, y, z));
        Unsafe.SkipInit(out s);
        s.SurfaceU = s.SurfaceV = R.Zero;
        s.LocalX = x * toUnit;
        s.LocalY = y * toUnit;
        s.LocalZ = z * toUnit;
        s.NormalX = s.ShadingX = s.LocalNormalX = s.LocalX;
        s.NormalY = s.ShadingY = s.LocalNormalY = s.LocalY;
        s.NormalZ = s.ShadingZ = s.LocalNormalZ = s.LocalZ;
        s.PointX = R.Fma(radius, s.LocalX, shape[CenterX]);
        s.PointY = R.Fma(radius, s.LocalY, shape[CenterY]);
        s.PointZ = R.Fma(radius, s.LocalZ, shape[CenterZ]);
        s.Slack = SlackOf<R, P>(shape);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static R SlackOf<R, P>(in P shape)
        where R : unmanaged, IReal<R>
        where P : struct, IParameters<R> => Lane.Slack(R.Abs(shape[CenterX]) + R.Abs(shape[CenterY]) + R.Abs(shape[CenterZ]) + shape[Radius]);

    /// <summary>Half the chord in units of the direction (0 for a miss) around l + step d; returns the squared half chord in object units, below 0 for a miss.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static R HalfChord<R>(in CentredRay<R> ray, R radius, out R step, out R half)
        where R : unmanaged, IReal<R>
    {
        // The step to the point that is nearest even after rounding; its square is what l^2 is too long by.
        R along = Lane.Dot(ray.X, ray.Y, ray.Z, ray.DirectionX, ray.DirectionY, ray.DirectionZ);
        step = -along * ray.InverseLengthSquared;
        R distanceSquared = R.Fma(step, along, Lane.Dot(ray.X, ray.Y, ray.Z, ray.X, ray.Y, ray.Z));
        R discriminant = R.Fma(radius, radius, -distanceSquared);
        half = R.Sqrt(R.Max(discriminant * ray.InverseLengthSquared, R.Zero));
        return discriminant;
    }

    public static void LocalFrame<R, P>(in P shape, out LinearLanes<R> frame)
        where R : unmanaged, IReal<R>
        where P : struct, IParameters<R>
    {
        R scale = R.Of(1) / shape[Radius];
        frame = LinearLanes<R>.Scaling(scale, scale, scale);
    }

    public static void BendNormal<R, P>(in P shape, R x, R y, R z, R stepX, R stepY, R stepZ, out NormalLanes<R> normal)
        where R : unmanaged, IReal<R>
        where P : struct, IParameters<R> =>
        normal = new NormalLanes<R> { X = x, Y = y, Z = z, StepX = stepX, StepY = stepY, StepZ = stepZ };
}
