namespace LabRaytracer;

/// <summary>The formulas of <see cref="InfinitePlane"/>: a point, the unit normal, and the two axes of its local frame.</summary>
internal readonly struct PlaneKernel : IShapeKernel
{
    private const int Point = 0, Normal = 3, AxisX = 6, AxisZ = 9;

    public static int ParameterCount => 12;

    public static void Describe(Shape shape, Transform transform, Span<double> numbers)
    {
        InfinitePlane plane = (InfinitePlane)shape;
        ReadOnlySpan<double> described =
        [
            plane.Point.X, plane.Point.Y, plane.Point.Z, plane.Normal.X, plane.Normal.Y, plane.Normal.Z,
            plane.LocalX.X, plane.LocalX.Y, plane.LocalX.Z, plane.LocalZ.X, plane.LocalZ.Y, plane.LocalZ.Z,
        ];
        described.CopyTo(numbers);
    }

    public static R Intersect<R, P>(in P shape, in RayLanes<R> ray, out R t)
        where R : unmanaged, IReal<R>
        where P : struct, IParameters<R>
    {
        R nx = shape[Normal], ny = shape[Normal + 1], nz = shape[Normal + 2];
        R height = Lane.Dot(nx, ny, nz, shape[Point] - ray.OriginX, shape[Point + 1] - ray.OriginY, shape[Point + 2] - ray.OriginZ);
        R approach = Lane.Dot(nx, ny, nz, ray.DirectionX, ray.DirectionY, ray.DirectionZ);

        // 0 / 0 (a ray inside the plane) is NaN, which is no hit; x / 0 is infinite, beyond every limit.
        t = height / approach;
        return R.Less(R.Zero, t) & R.Less(t, R.Of(double.PositiveInfinity));
    }

    /// <remarks>The point is put back into the plane along its normal, so that y = 0 holds exactly in the local frame.</remarks>
    public static void Surface<R, P>(in P shape, in RayLanes<R> ray, R t, out SurfaceLanes<R> s)
        where R : unmanaged, IReal<R>
        where P : struct, IParameters<R>
    {
        s = default;
        s.NormalX = s.ShadingX = shape[Normal];
        s.NormalY = s.ShadingY = shape[Normal + 1];
        s.NormalZ = s.ShadingZ = shape[Normal + 2];
        R qx = R.Fma(t, ray.DirectionX, ray.OriginX - shape[Point]);
        R qy = R.Fma(t, ray.DirectionY, ray.OriginY - shape[Point + 1]);
        R qz = R.Fma(t, ray.DirectionZ, ray.OriginZ - shape[Point + 2]);
        R off = Lane.Dot(qx, qy, qz, s.NormalX, s.NormalY, s.NormalZ);
        qx = R.Fma(-off, s.NormalX, qx);
        qy = R.Fma(-off, s.NormalY, qy);
        qz = R.Fma(-off, s.NormalZ, qz);
        s.LocalX = Lane.Dot(qx, qy, qz, shape[AxisX], shape[AxisX + 1], shape[AxisX + 2]);
        s.LocalZ = Lane.Dot(qx, qy, qz, shape[AxisZ], shape[AxisZ + 1], shape[AxisZ + 2]);
        s.LocalNormalY = R.Of(1);
        s.PointX = shape[Point] + qx;
        s.PointY = shape[Point + 1] + qy;
        s.PointZ = shape[Point + 2] + qz;
        s.Slack = Lane.Slack(
            R.Abs(shape[Point]) + R.Abs(shape[Point + 1]) + R.Abs(shape[Point + 2]) + R.Abs(qx) + R.Abs(qy) + R.Abs(qz)
            + R.Abs(ray.OriginX) + R.Abs(ray.OriginY) + R.Abs(ray.OriginZ));
    }
}
