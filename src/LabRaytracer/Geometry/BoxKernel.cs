using System.Runtime.CompilerServices;

namespace LabRaytracer;

/// <summary>The formulas of <see cref="Box"/>: centre x, y, z and half the size along x, y, z.</summary>
internal readonly struct BoxKernel : IShapeKernel
{
    private const int CenterX = 0, CenterY = 1, CenterZ = 2, HalfX = 3, HalfY = 4, HalfZ = 5;

    public static int ParameterCount => 6;

    public static bool IsConvex => true;

    public static void Describe(Shape shape, Transform transform, Span<double> numbers)
    {
        Box box = (Box)shape;
        numbers[CenterX] = box.Center.X;
        numbers[CenterY] = box.Center.Y;
        numbers[CenterZ] = box.Center.Z;
        numbers[HalfX] = box.Half.X;
        numbers[HalfY] = box.Half.Y;
        numbers[HalfZ] = box.Half.Z;
    }

    [MethodImpl(MethodImplOptions.NoInlining)]
    public static R Intersect<R, P>(in P shape, in RayLanes<R> ray, out R t)
        where R : unmanaged, IReal<R>
        where P : struct, IParameters<R>
    {
        CentredRay<R>.Of(ray, shape, CenterX, out CentredRay<R> centred);
        R mask = Cut(shape, centred, out R near, out R far, out _, out _);
        R tNear = centred.K + near;
        t = R.Select(R.Less(R.Zero, tNear), tNear, centred.K + far);
        return mask & R.Less(R.Zero, t) & R.Less(t, R.Of(double.PositiveInfinity));
    }

    /// <remarks>The coordinate along the normal of the face is exactly plus or minus half the size, the others stay within the face.</remarks>
    [MethodImpl(MethodImplOptions.NoInlining)]
    public static void Surface<R, P>(in P shape, in RayLanes<R> ray, ref R t, out SurfaceLanes<R> s)
        where R : unmanaged, IReal<R>
        where P : struct, IParameters<R>
    {
        CentredRay<R>.Of(ray, shape, CenterX, out CentredRay<R> centred);
        Cut(shape, centred, out R near, out R far, out Faces<R> nearFaces, out Faces<R> farFaces);
        R isNear = R.Less(R.Zero, centred.K + near);
        R along = R.Select(isNear, near, far);
        R onX = R.Equal(R.Select(isNear, nearFaces.X, farFaces.X), along);
        R onY = R.Equal(R.Select(isNear, nearFaces.Y, farFaces.Y), along) & ~onX;
        R onZ = ~(onX | onY);

        // A ray leaves through the face that it looks at and enters through one that looks back at it.
        R back = isNear & R.Of(-0.0);
        s = default;
        s.NormalX = s.ShadingX = s.LocalNormalX = onX & (SignOne(ray.DirectionX) ^ back);
        s.NormalY = s.ShadingY = s.LocalNormalY = onY & (SignOne(ray.DirectionY) ^ back);
        s.NormalZ = s.ShadingZ = s.LocalNormalZ = onZ & (SignOne(ray.DirectionZ) ^ back);
        s.LocalX = Local(shape[HalfX], R.Fma(along, ray.DirectionX, centred.X), onX, s.NormalX);
        s.LocalY = Local(shape[HalfY], R.Fma(along, ray.DirectionY, centred.Y), onY, s.NormalY);
        s.LocalZ = Local(shape[HalfZ], R.Fma(along, ray.DirectionZ, centred.Z), onZ, s.NormalZ);
        s.PointX = R.Fma(s.LocalX, shape[HalfX], shape[CenterX]);
        s.PointY = R.Fma(s.LocalY, shape[HalfY], shape[CenterY]);
        s.PointZ = R.Fma(s.LocalZ, shape[HalfZ], shape[CenterZ]);
        s.Slack = Lane.Slack(
            R.Abs(shape[CenterX]) + R.Abs(shape[CenterY]) + R.Abs(shape[CenterZ]) + shape[HalfX] + shape[HalfY] + shape[HalfZ]);
    }

    /// <summary>The part [near, far] of the ray between all three pairs of faces, and where it meets each.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static R Cut<R, P>(in P shape, in CentredRay<R> ray, out R near, out R far, out Faces<R> nearFaces, out Faces<R> farFaces)
        where R : unmanaged, IReal<R>
        where P : struct, IParameters<R>
    {
        Slab(shape[HalfX], ray.X, ray.DirectionX, out nearFaces.X, out farFaces.X);
        Slab(shape[HalfY], ray.Y, ray.DirectionY, out nearFaces.Y, out farFaces.Y);
        Slab(shape[HalfZ], ray.Z, ray.DirectionZ, out nearFaces.Z, out farFaces.Z);
        near = R.Max(R.Max(nearFaces.X, nearFaces.Y), nearFaces.Z);
        far = R.Min(R.Min(farFaces.X, farFaces.Y), farFaces.Z);
        return R.LessOrEqual(near, far);
    }

    /// <summary>Where the ray is between two parallel faces; a ray inside of them and parallel to them always is.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void Slab<R>(R half, R start, R direction, out R near, out R far)
        where R : unmanaged, IReal<R>
    {
        // Mirrored so that the direction is positive. Parallel rays would divide 0 by 0 on the face itself: they get the infinities explicitly.
        R forward = start ^ (direction & R.Of(-0.0));
        R speed = R.Abs(direction);
        R parallel = R.Equal(speed, R.Zero);
        R inside = R.LessOrEqual(R.Abs(start), half);
        R infinity = R.Of(double.PositiveInfinity);
        near = R.Select(parallel, R.Select(inside, -infinity, infinity), (-half - forward) / speed);
        far = R.Select(parallel, R.Select(inside, infinity, -infinity), (half - forward) / speed);
    }

    /// <summary>One coordinate of the local point, [-1, 1].</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static R Local<R>(R half, R offset, R onFace, R normal)
        where R : unmanaged, IReal<R> => R.Select(onFace, normal, R.Max(R.Min(offset / half, R.Of(1)), R.Of(-1)));

    /// <summary>1 with the sign of a number.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static R SignOne<R>(R a)
        where R : unmanaged, IReal<R> => R.Of(1) | (a & R.Of(-0.0));

    /// <summary>One number for each axis.</summary>
    private struct Faces<R>
    {
        public R X, Y, Z;
    }

    public static void LocalFrame<R, P>(in P shape, out LinearLanes<R> frame)
        where R : unmanaged, IReal<R>
        where P : struct, IParameters<R> =>
        frame = LinearLanes<R>.Scaling(R.Of(1) / shape[HalfX], R.Of(1) / shape[HalfY], R.Of(1) / shape[HalfZ]);
}
