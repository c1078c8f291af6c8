using System.Numerics;
using System.Runtime.CompilerServices;

namespace LabRaytracer;

/// <summary>The formulas of <see cref="InfinitePlane"/>: a point, the unit normal, the two axes of its local frame, and whether it is a floor.</summary>
/// <remarks>A floor, y = c seen from above, makes most products 0 or exact: <see cref="FloorKernel"/> gives the same numbers with a quarter of the work.</remarks>
[SkipLocalsInit]
internal readonly unsafe struct PlaneKernel : IShapeKernel
{
    private const int Point = 0, Normal = 3, AxisX = 6, AxisZ = 9, Floor = 12;

    public static int ParameterCount => 13;

    public static bool IsConvex => true;

    public static bool HasQuickLook => true;

    public static bool IsSmooth => true;

    public static void Describe(Shape shape, Transform transform, Span<double> numbers)
    {
        InfinitePlane plane = (InfinitePlane)shape;
        ReadOnlySpan<double> described =
        [
            plane.Point.X, plane.Point.Y, plane.Point.Z, plane.Normal.X, plane.Normal.Y, plane.Normal.Z,
            plane.LocalX.X, plane.LocalX.Y, plane.LocalX.Z, plane.LocalZ.X, plane.LocalZ.Y, plane.LocalZ.Z,
            plane.Normal == Vector3D.UnitY && plane.LocalX == Vector3D.UnitX && plane.LocalZ == Vector3D.UnitZ ? 1 : 0,
        ];
        described.CopyTo(numbers);
    }

    /// <summary>Tells whether all lanes see floors.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static bool IsFloor<R, P>(in P shape)
        where R : unmanaged, IReal<R>
        where P : struct, IParameters<R> => R.All(R.Less(R.Zero, shape[Floor]));

    public static bool IsQuick(ReadOnlySpan<double> numbers) => numbers[Floor] > 0;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static R IntersectQuick<R, P>(in P shape, in RayColumns<R> ray, int packet, out R t)
        where R : unmanaged, IReal<R>
        where P : struct, IParameters<R> => FloorKernel.Intersect(shape[Point + 1], ray.OriginY[packet], ray.DirectionY[packet], out t);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static R Intersect<R, P>(in P shape, in RayLanes<R> ray, out R t)
        where R : unmanaged, IReal<R>
        where P : struct, IParameters<R> => IsFloor<R, P>(shape)
            ? FloorKernel.Intersect(shape[Point + 1], ray.OriginY, ray.DirectionY, out t)
            : IntersectAny(shape, ray, out t);

    /// <remarks>
    /// t = n.(q - o) / n.d, all of it as if with twice the digits: t is within 1 ulp also for rays that graze the plane or start near it.
    /// </remarks>
    [MethodImpl(MethodImplOptions.NoInlining)]
    private static R IntersectAny<R, P>(in P shape, in RayLanes<R> ray, out R t)
        where R : unmanaged, IReal<R>
        where P : struct, IParameters<R>
    {
        R nx = shape[Normal], ny = shape[Normal + 1], nz = shape[Normal + 2];
        R qx = Compensated.Difference(shape[Point], ray.OriginX, out R restX);
        R qy = Compensated.Difference(shape[Point + 1], ray.OriginY, out R restY);
        R qz = Compensated.Difference(shape[Point + 2], ray.OriginZ, out R restZ);
        R heightPart = Compensated.Dot(nx, ny, nz, qx, qy, qz, out R heightRest);
        heightRest += Lane.Dot(nx, ny, nz, restX, restY, restZ);
        R height = heightPart + heightRest;
        heightRest -= height - heightPart;
        R approachPart = Compensated.Dot(nx, ny, nz, ray.DirectionX, ray.DirectionY, ray.DirectionZ, out R approachRest);
        R approach = approachPart + approachRest;
        approachRest -= approach - approachPart;

        // One more step of the division. A ray inside the plane or parallel to it makes NaN of it, which is no hit.
        R inverse = R.Of(1) / approach;
        R quotient = height * inverse;
        t = R.Fma(R.Fma(-quotient, approach, height) + R.Fma(-quotient, approachRest, heightRest), inverse, quotient);
        return R.Less(R.Zero, t) & R.Less(t, R.Of(double.PositiveInfinity));
    }

    /// <remarks>
    /// The height over the plane is wrong by at most 8 units of 2^-24 of the coordinates that it is made of, the approach by 8 units: a ray that starts above by more
    /// than that and moves away by more than that meets no plane.
    /// </remarks>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static F MayHit<F, P>(in P shape, in RayLanes<F> ray)
        where F : unmanaged, IReal<F>
        where P : struct, IParameters<F>
    {
        F nx = shape[Normal], ny = shape[Normal + 1], nz = shape[Normal + 2];
        F px = shape[Point], py = shape[Point + 1], pz = shape[Point + 2];
        F height = Lane.Dot(nx, ny, nz, ray.OriginX - px, ray.OriginY - py, ray.OriginZ - pz);
        F approach = Lane.Dot(nx, ny, nz, ray.DirectionX, ray.DirectionY, ray.DirectionZ);
        F size = F.Abs(px) + F.Abs(py) + F.Abs(pz) + F.Abs(ray.OriginX) + F.Abs(ray.OriginY) + F.Abs(ray.OriginZ);
        F length = F.Abs(ray.DirectionX) + F.Abs(ray.DirectionY) + F.Abs(ray.DirectionZ);

        // 1e-37 more, below which floats lose their digits.
        F unsure = F.LessOrEqual(F.Abs(height), F.Fma(size, F.Of(8.0 / (1 << 24)), F.Of(1e-37))) | F.LessOrEqual(F.Abs(approach), length * F.Of(8.0 / (1 << 24)));

        // Height and approach of different signs: the ray comes nearer.
        return unsure | (F.Less(height, F.Zero) ^ F.Less(approach, F.Zero));
    }

    public static bool MayMeet(ReadOnlySpan<double> numbers, in RayBounds bounds) =>
        bounds.MayMeetPlane(new Point3D(numbers[Point], numbers[Point + 1], numbers[Point + 2]), new Vector3D(numbers[Normal], numbers[Normal + 1], numbers[Normal + 2]));

    [MethodImpl(MethodImplOptions.NoInlining)]
    public static void Surface<R, P>(in P shape, in RayLanes<R> ray, ref R t, out SurfaceLanes<R> s)
        where R : unmanaged, IReal<R>
        where P : struct, IParameters<R>
    {
        Unsafe.SkipInit(out s);
        Reach(shape, ray, t, out R qx, out R qy, out R qz);
        s.NormalX = s.ShadingX = shape[Normal];
        s.NormalY = s.ShadingY = shape[Normal + 1];
        s.NormalZ = s.ShadingZ = shape[Normal + 2];
        s.LocalX = Lane.Dot(qx, qy, qz, shape[AxisX], shape[AxisX + 1], shape[AxisX + 2]);
        s.LocalZ = Lane.Dot(qx, qy, qz, shape[AxisZ], shape[AxisZ + 1], shape[AxisZ + 2]);
        s.LocalY = s.LocalNormalX = s.LocalNormalZ = s.SurfaceU = s.SurfaceV = R.Zero;
        s.LocalNormalY = R.Of(1);
        s.PointX = shape[Point] + qx;
        s.PointY = shape[Point + 1] + qy;
        s.PointZ = shape[Point + 2] + qz;
        s.Slack = SlackOf(shape, qx, qy, qz);
    }

    [MethodImpl(MethodImplOptions.NoInlining)]
    public static uint Smooth<R, P>(in P shape, in RayLanes<R> ray, in R t, in SurfaceColumns<R> to, int packet, SurfaceNeeds needs)
        where R : unmanaged, IReal<R>
        where P : struct, IParameters<R>
    {
        if (IsFloor<R, P>(shape))
        {
            SmoothQuick(shape, ray.OriginX, ray.OriginY, ray.OriginZ, ray.DirectionX, ray.DirectionY, ray.DirectionZ, t, to, packet, needs);
            return 0;
        }

        PositionBatch<R> p = to.Positions;
        Reach(shape, ray, t, out R qx, out R qy, out R qz);
        p.WorldX[packet] = shape[Point] + qx;
        p.WorldY[packet] = shape[Point + 1] + qy;
        p.WorldZ[packet] = shape[Point + 2] + qz;
        p.WorldNormalX[packet] = shape[Normal];
        p.WorldNormalY[packet] = shape[Normal + 1];
        p.WorldNormalZ[packet] = shape[Normal + 2];
        to.Slack[packet] = SlackOf(shape, qx, qy, qz);
        R localX = Lane.Dot(qx, qy, qz, shape[AxisX], shape[AxisX + 1], shape[AxisX + 2]);
        R localZ = Lane.Dot(qx, qy, qz, shape[AxisZ], shape[AxisZ + 1], shape[AxisZ + 2]);
        StoreLocal(p, packet, localX, localZ, needs);
        return 0;
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void SmoothQuick<R, P>(
        in P shape, R originX, R originY, R originZ, R directionX, R directionY, R directionZ, R t, in SurfaceColumns<R> to, int packet, SurfaceNeeds needs)
        where R : unmanaged, IReal<R>
        where P : struct, IParameters<R>
    {
        PositionBatch<R> p = to.Positions;
        R x = shape[Point], y = shape[Point + 1], z = shape[Point + 2];
        FloorKernel.Reach(x, y, z, originX, originY, originZ, directionX, directionY, directionZ, t, out R localX, out R localZ);
        p.WorldX[packet] = x + localX;
        p.WorldY[packet] = y;
        p.WorldZ[packet] = z + localZ;
        p.WorldNormalX[packet] = p.WorldNormalZ[packet] = R.Zero;
        p.WorldNormalY[packet] = R.Of(1);
        to.Slack[packet] = SlackOf(shape, localX, R.Zero, localZ);
        StoreLocal(p, packet, localX, localZ, needs);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void StoreLocal<R>(in PositionBatch<R> p, int packet, R x, R z, SurfaceNeeds needs)
        where R : unmanaged, IReal<R>
    {
        if ((needs & SurfaceNeeds.LocalPoint) != 0)
        {
            p.X[packet] = x;
            p.Y[packet] = R.Zero;
            p.Z[packet] = z;
        }

        if ((needs & SurfaceNeeds.LocalNormal) != 0)
        {
            p.NormalX[packet] = p.NormalZ[packet] = R.Zero;
            p.NormalY[packet] = R.Of(1);
        }

        if ((needs & SurfaceNeeds.SurfaceCoordinates) != 0)
        {
            p.SurfaceU[packet] = p.SurfaceV[packet] = R.Zero;
        }
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static R SlackOf<R, P>(in P shape, R qx, R qy, R qz)
        where R : unmanaged, IReal<R>
        where P : struct, IParameters<R> => Lane.Slack(
            R.Abs(shape[Point]) + R.Abs(shape[Point + 1]) + R.Abs(shape[Point + 2]) + R.Abs(qx) + R.Abs(qy) + R.Abs(qz));

    /// <summary>The point relative to the plane's own point.</summary>
    /// <remarks>
    /// It takes one more step along the ray, which removes what rounding t cost: it is accurate at any distance.
    /// It is then put back into the plane along the normal, so that y = 0 holds exactly in the local frame.
    /// </remarks>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void Reach<R, P>(in P shape, in RayLanes<R> ray, R t, out R qx, out R qy, out R qz)
        where R : unmanaged, IReal<R>
        where P : struct, IParameters<R>
    {
        R nx = shape[Normal], ny = shape[Normal + 1], nz = shape[Normal + 2];
        qx = R.Fma(t, ray.DirectionX, Compensated.Difference(ray.OriginX, shape[Point], out R restX)) + restX;
        qy = R.Fma(t, ray.DirectionY, Compensated.Difference(ray.OriginY, shape[Point + 1], out R restY)) + restY;
        qz = R.Fma(t, ray.DirectionZ, Compensated.Difference(ray.OriginZ, shape[Point + 2], out R restZ)) + restZ;
        R approach = Lane.Dot(nx, ny, nz, ray.DirectionX, ray.DirectionY, ray.DirectionZ);
        R again = -Lane.Dot(nx, ny, nz, qx, qy, qz) / approach;
        qx = R.Fma(again, ray.DirectionX, qx);
        qy = R.Fma(again, ray.DirectionY, qy);
        qz = R.Fma(again, ray.DirectionZ, qz);
        R off = Lane.Dot(qx, qy, qz, nx, ny, nz);
        qx = R.Fma(-off, nx, qx);
        qy = R.Fma(-off, ny, qy);
        qz = R.Fma(-off, nz, qz);
    }

    /// <remarks>
    /// t alone: the surface takes its own step along the ray already. With u the precision, the height is within 8 u² of the sum of its terms' magnitudes and the
    /// approach within 6 u² of the sum of its own, the quotient within 15 u² more: all below 32.
    /// </remarks>
    [MethodImpl(MethodImplOptions.NoInlining)]
    public static void Sharpen<R, P>(in P shape, in RayLanes<R> ray, ref R t, ref SurfaceLanes<R> s)
        where R : unmanaged, IReal<R>
        where P : struct, IParameters<R>
    {
        R nx = shape[Normal], ny = shape[Normal + 1], nz = shape[Normal + 2];
        DoubleWord<R> x = DoubleWord<R>.Difference(shape[Point], ray.OriginX) * nx;
        DoubleWord<R> y = DoubleWord<R>.Difference(shape[Point + 1], ray.OriginY) * ny;
        DoubleWord<R> z = DoubleWord<R>.Difference(shape[Point + 2], ray.OriginZ) * nz;
        DoubleWord<R> dx = DoubleWord<R>.Product(nx, ray.DirectionX), dy = DoubleWord<R>.Product(ny, ray.DirectionY), dz = DoubleWord<R>.Product(nz, ray.DirectionZ);
        DoubleWord<R> approach = dx + dy + dz, quotient = (x + y + z) / approach;
        R heights = R.Abs(x.High) + R.Abs(y.High) + R.Abs(z.High), approaches = R.Abs(dx.High) + R.Abs(dy.High) + R.Abs(dz.High);
        R error = R.Of(0.25) * RoundedParameter.Unit<R>() * R.Fma(R.Abs(quotient.High), approaches, heights) / R.Abs(approach.High);
        R isExact = RoundedParameter.IsCertain(quotient, error) & RoundedParameter.IsOrdinary(heights) & RoundedParameter.IsOrdinary(approaches);
        t = R.Select(isExact, quotient.High, t);
        for (uint open = R.Bits(~isExact); open != 0; open &= open - 1)
        {
            int lane = BitOperations.TrailingZeroCount(open);
            Point3D point = new(R.Get(shape[Point], lane), R.Get(shape[Point + 1], lane), R.Get(shape[Point + 2], lane));
            Vector3D normal = new(R.Get(nx, lane), R.Get(ny, lane), R.Get(nz, lane));
            t = RoundedParameter.Replace(t, lane, ExactDistance.OfPlane(RoundedParameter.Lane(ray, lane), point, normal));
        }
    }

    public static void LocalFrame<R, P>(in P shape, out LinearLanes<R> frame)
        where R : unmanaged, IReal<R>
        where P : struct, IParameters<R> => frame = new LinearLanes<R>
        {
            XX = shape[AxisX], XY = shape[AxisX + 1], XZ = shape[AxisX + 2],
            YX = shape[Normal], YY = shape[Normal + 1], YZ = shape[Normal + 2],
            ZX = shape[AxisZ], ZY = shape[AxisZ + 1], ZZ = shape[AxisZ + 2],
        };
}
