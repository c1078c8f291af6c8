using System.Runtime.CompilerServices;

namespace LabRaytracer;

/// <summary>The formulas of flat shapes with an outline (<see cref="Quad"/>, <see cref="Disk"/>).</summary>
/// <typeparam name="TOutline">The outline in the local frame.</typeparam>
internal readonly struct FlatKernel<TOutline> : IShapeKernel
    where TOutline : struct, IOutline
{
    private const int Center = 0, Normal = 3, DualX = 6, DualZ = 9, AxisX = 12, AxisZ = 15;

    public static int ParameterCount => 18;

    public static bool IsConvex => true;

    public static void Describe(Shape shape, Transform transform, Span<double> numbers)
    {
        FlatFrame frame = ((IFlatShape)shape).Frame;
        ReadOnlySpan<Vector3D> described = [frame.Center.ToVector(), frame.Normal, frame.DualX, frame.DualZ, frame.AxisX, frame.AxisZ];
        for (int k = 0; k < described.Length; k++)
        {
            numbers[3 * k] = described[k].X;
            numbers[(3 * k) + 1] = described[k].Y;
            numbers[(3 * k) + 2] = described[k].Z;
        }
    }

    /// <remarks>t = k + s with s = -n.l / n.d from the ray's point l nearest to the centre: what is inside the outline does not depend on the distance.</remarks>
    [MethodImpl(MethodImplOptions.NoInlining)]
    public static R Intersect<R, P>(in P shape, in RayLanes<R> ray, out R t)
        where R : unmanaged, IReal<R>
        where P : struct, IParameters<R>
    {
        Locate(shape, ray, out t, out R x, out R z);
        return TOutline.Contains(x, z) & R.Less(R.Zero, t) & R.Less(t, R.Of(double.PositiveInfinity));
    }

    /// <remarks>The point is rebuilt from its local coordinates, so that it lies in the plane.</remarks>
    [MethodImpl(MethodImplOptions.NoInlining)]
    public static void Surface<R, P>(in P shape, in RayLanes<R> ray, ref R t, out SurfaceLanes<R> s)
        where R : unmanaged, IReal<R>
        where P : struct, IParameters<R>
    {
        s = default;
        Locate(shape, ray, out _, out s.LocalX, out s.LocalZ);
        s.LocalNormalY = R.Of(1);
        s.NormalX = s.ShadingX = shape[Normal];
        s.NormalY = s.ShadingY = shape[Normal + 1];
        s.NormalZ = s.ShadingZ = shape[Normal + 2];
        s.PointX = R.Fma(s.LocalX, shape[AxisX], R.Fma(s.LocalZ, shape[AxisZ], shape[Center]));
        s.PointY = R.Fma(s.LocalX, shape[AxisX + 1], R.Fma(s.LocalZ, shape[AxisZ + 1], shape[Center + 1]));
        s.PointZ = R.Fma(s.LocalX, shape[AxisX + 2], R.Fma(s.LocalZ, shape[AxisZ + 2], shape[Center + 2]));
        s.Slack = Lane.Slack(Size<R, P>(shape, Center) + Size<R, P>(shape, AxisX) + Size<R, P>(shape, AxisZ));
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void Locate<R, P>(in P shape, in RayLanes<R> ray, out R t, out R x, out R z)
        where R : unmanaged, IReal<R>
        where P : struct, IParameters<R>
    {
        CentredRay<R>.Of(ray, shape, Center, out CentredRay<R> centred);
        R nx = shape[Normal], ny = shape[Normal + 1], nz = shape[Normal + 2];
        R height = Compensated.Dot(nx, ny, nz, centred.X, centred.Y, centred.Z);
        R approach = Compensated.Dot(nx, ny, nz, ray.DirectionX, ray.DirectionY, ray.DirectionZ);

        // A ray along the plane gives NaN or infinity, which no comparison lets through.
        R along = -height / approach;
        t = centred.K + along;
        R px = R.Fma(along, ray.DirectionX, centred.X);
        R py = R.Fma(along, ray.DirectionY, centred.Y);
        R pz = R.Fma(along, ray.DirectionZ, centred.Z);
        x = Lane.Dot(px, py, pz, shape[DualX], shape[DualX + 1], shape[DualX + 2]);
        z = Lane.Dot(px, py, pz, shape[DualZ], shape[DualZ + 1], shape[DualZ + 2]);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static R Size<R, P>(in P shape, int at)
        where R : unmanaged, IReal<R>
        where P : struct, IParameters<R> => R.Abs(shape[at]) + R.Abs(shape[at + 1]) + R.Abs(shape[at + 2]);

    public static void LocalFrame<R, P>(in P shape, out LinearLanes<R> frame)
        where R : unmanaged, IReal<R>
        where P : struct, IParameters<R> => frame = new LinearLanes<R>
        {
            XX = shape[DualX], XY = shape[DualX + 1], XZ = shape[DualX + 2],
            YX = shape[Normal], YY = shape[Normal + 1], YZ = shape[Normal + 2],
            ZX = shape[DualZ], ZY = shape[DualZ + 1], ZZ = shape[DualZ + 2],
        };
}
