namespace LabRaytracer;

/// <summary>The formulas of <see cref="Sphere"/>: centre x, y, z and radius.</summary>
internal readonly struct SphereKernel : IShapeKernel
{
    private const int CenterX = 0, CenterY = 1, CenterZ = 2, Radius = 3;

    public static int ParameterCount => 4;

    public static void Describe(Shape shape, Transform transform, Span<double> numbers)
    {
        Sphere sphere = (Sphere)shape;
        numbers[CenterX] = sphere.Center.X;
        numbers[CenterY] = sphere.Center.Y;
        numbers[CenterZ] = sphere.Center.Z;
        numbers[Radius] = sphere.Radius;
    }

    /// <remarks>
    /// The ray is cut at its point nearest to the centre: the discriminant r^2 - l^2 then does not cancel against the distance
    /// (Haines et al., "Precision improvements for ray/sphere intersection", Ray Tracing Gems, 2019).
    /// </remarks>
    public static R Intersect<R, P>(in P shape, in RayLanes<R> ray, out R t)
        where R : unmanaged, IReal<R>
        where P : struct, IParameters<R>
    {
        R radius = shape[Radius];
        Reorigin(shape, ray, out R k, out R lx, out R ly, out R lz, out R lengthSquared);
        R distanceSquared = Lane.Dot(lx, ly, lz, lx, ly, lz);
        R discriminant = R.Fma(radius, radius, -distanceSquared);
        R half = R.Sqrt(R.Max(discriminant / lengthSquared, R.Zero));
        R near = k - half;
        R far = k + half;
        t = R.Select(R.Less(R.Zero, near), near, far);
        return R.LessOrEqual(R.Zero, discriminant) & R.Less(R.Zero, t);
    }

    /// <remarks>
    /// The local point is the nearest point l plus or minus half the chord, never o + t d - c: its error stays at a few ulp of the radius at any distance.
    /// </remarks>
    public static void Surface<R, P>(in P shape, in RayLanes<R> ray, R t, out SurfaceLanes<R> s)
        where R : unmanaged, IReal<R>
        where P : struct, IParameters<R>
    {
        R radius = shape[Radius];
        Reorigin(shape, ray, out R k, out R lx, out R ly, out R lz, out R lengthSquared);

        // A second step removes what the first one's rounding left along the ray.
        R again = -Lane.Dot(lx, ly, lz, ray.DirectionX, ray.DirectionY, ray.DirectionZ) / lengthSquared;
        lx = R.Fma(again, ray.DirectionX, lx);
        ly = R.Fma(again, ray.DirectionY, ly);
        lz = R.Fma(again, ray.DirectionZ, lz);
        R distance = R.Sqrt(Lane.Dot(lx, ly, lz, lx, ly, lz));
        R half = R.Sqrt(R.Max((radius - distance) * (radius + distance), R.Zero) / lengthSquared);
        half = R.Select(R.Less(t, k), -half, half);
        R x = R.Fma(half, ray.DirectionX, lx);
        R y = R.Fma(half, ray.DirectionY, ly);
        R z = R.Fma(half, ray.DirectionZ, lz);
        R toUnit = R.Of(1) / R.Sqrt(Lane.Dot(x, y, z, x, y, z));
        s = default;
        s.LocalX = x * toUnit;
        s.LocalY = y * toUnit;
        s.LocalZ = z * toUnit;
        s.NormalX = s.ShadingX = s.LocalNormalX = s.LocalX;
        s.NormalY = s.ShadingY = s.LocalNormalY = s.LocalY;
        s.NormalZ = s.ShadingZ = s.LocalNormalZ = s.LocalZ;
        s.PointX = R.Fma(radius, s.LocalX, shape[CenterX]);
        s.PointY = R.Fma(radius, s.LocalY, shape[CenterY]);
        s.PointZ = R.Fma(radius, s.LocalZ, shape[CenterZ]);
        s.Slack = Lane.Slack(R.Abs(shape[CenterX]) + R.Abs(shape[CenterY]) + R.Abs(shape[CenterZ]) + radius);
    }

    /// <summary>The ray's point nearest to the centre, relative to the centre: l = o - c + k d with l perpendicular to d.</summary>
    private static void Reorigin<R, P>(in P shape, in RayLanes<R> ray, out R k, out R lx, out R ly, out R lz, out R lengthSquared)
        where R : unmanaged, IReal<R>
        where P : struct, IParameters<R>
    {
        R fx = ray.OriginX - shape[CenterX];
        R fy = ray.OriginY - shape[CenterY];
        R fz = ray.OriginZ - shape[CenterZ];
        lengthSquared = Lane.Dot(ray.DirectionX, ray.DirectionY, ray.DirectionZ, ray.DirectionX, ray.DirectionY, ray.DirectionZ);
        k = -Lane.Dot(fx, fy, fz, ray.DirectionX, ray.DirectionY, ray.DirectionZ) / lengthSquared;
        lx = R.Fma(k, ray.DirectionX, fx);
        ly = R.Fma(k, ray.DirectionY, fy);
        lz = R.Fma(k, ray.DirectionZ, fz);
    }
}
