using System.Runtime.CompilerServices;

namespace LabRaytracer;

/// <summary>A kernel behind a transform: rays go to object space, surfaces come back to world space.</summary>
/// <typeparam name="K">The kernel in object space.</typeparam>
/// <remarks>The 12 numbers world to object, the 12 numbers object to world, then the shape's own.</remarks>
internal readonly struct TransformedKernel<K> : IShapeKernel
    where K : struct, IShapeKernel
{
    private const int ObjectFromWorld = 0, WorldFromObject = 12, Own = 24;

    public static int ParameterCount => Own + K.ParameterCount;

    public static void Describe(Shape shape, Transform transform, Span<double> numbers)
    {
        transform.ObjectFromWorldRows.CopyTo(numbers[ObjectFromWorld..]);
        transform.WorldFromObjectRows.CopyTo(numbers[WorldFromObject..]);
        K.Describe(shape, Transform.Identity, numbers[Own..]);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static R Intersect<R, P>(in P shape, in RayLanes<R> ray, out R t)
        where R : unmanaged, IReal<R>
        where P : struct, IParameters<R> =>
        K.Intersect(new OffsetParameters<R, P>(shape, Own), ToObject<R, P>(shape, ray), out t);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void Surface<R, P>(in P shape, in RayLanes<R> ray, R t, out SurfaceLanes<R> s)
        where R : unmanaged, IReal<R>
        where P : struct, IParameters<R>
    {
        K.Surface(new OffsetParameters<R, P>(shape, Own), ToObject<R, P>(shape, ray), t, out s);
        s.Slack = WorldSlack<R, P>(shape, s);
        (s.PointX, s.PointY, s.PointZ) = Apply<R, P>(shape, WorldFromObject, s.PointX, s.PointY, s.PointZ, R.Of(1));
        (s.NormalX, s.NormalY, s.NormalZ) = WorldNormal(shape, s.NormalX, s.NormalY, s.NormalZ);
        (s.ShadingX, s.ShadingY, s.ShadingZ) = WorldNormal(shape, s.ShadingX, s.ShadingY, s.ShadingZ);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static RayLanes<R> ToObject<R, P>(in P shape, in RayLanes<R> ray)
        where R : unmanaged, IReal<R>
        where P : struct, IParameters<R>
    {
        (R ox, R oy, R oz) = Apply(shape, ObjectFromWorld, ray.OriginX, ray.OriginY, ray.OriginZ, R.Of(1));
        (R dx, R dy, R dz) = Apply(shape, ObjectFromWorld, ray.DirectionX, ray.DirectionY, ray.DirectionZ, R.Zero);
        return new RayLanes<R>(ox, oy, oz, dx, dy, dz);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static (R X, R Y, R Z) Apply<R, P>(in P m, int at, R x, R y, R z, R w)
        where R : unmanaged, IReal<R>
        where P : struct, IParameters<R> => (
            R.Fma(m[at], x, R.Fma(m[at + 1], y, R.Fma(m[at + 2], z, m[at + 3] * w))),
            R.Fma(m[at + 4], x, R.Fma(m[at + 5], y, R.Fma(m[at + 6], z, m[at + 7] * w))),
            R.Fma(m[at + 8], x, R.Fma(m[at + 9], y, R.Fma(m[at + 10], z, m[at + 11] * w))));

    /// <summary>Normals map with the inverse transpose: the columns of the matrix world to object.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static (R X, R Y, R Z) WorldNormal<R, P>(in P m, R x, R y, R z)
        where R : unmanaged, IReal<R>
        where P : struct, IParameters<R>
    {
        R wx = Lane.Dot(m[ObjectFromWorld], m[ObjectFromWorld + 4], m[ObjectFromWorld + 8], x, y, z);
        R wy = Lane.Dot(m[ObjectFromWorld + 1], m[ObjectFromWorld + 5], m[ObjectFromWorld + 9], x, y, z);
        R wz = Lane.Dot(m[ObjectFromWorld + 2], m[ObjectFromWorld + 6], m[ObjectFromWorld + 10], x, y, z);
        R toUnit = R.Of(1) / R.Sqrt(Lane.Dot(wx, wy, wz, wx, wy, wz));
        return (wx * toUnit, wy * toUnit, wz * toUnit);
    }

    /// <summary>The object-space slack and the rounding of the transform, through the absolute values of the matrix.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static R WorldSlack<R, P>(in P m, in SurfaceLanes<R> s)
        where R : unmanaged, IReal<R>
        where P : struct, IParameters<R>
    {
        R worst = R.Zero;
        R x = R.Abs(s.PointX), y = R.Abs(s.PointY), z = R.Abs(s.PointZ);
        for (int row = WorldFromObject; row < WorldFromObject + 12; row += 4)
        {
            R mx = R.Abs(m[row]), my = R.Abs(m[row + 1]), mz = R.Abs(m[row + 2]);
            R rounding = Lane.Slack(Lane.Dot(mx, my, mz, x, y, z) + R.Abs(m[row + 3]));
            worst = R.Max(worst, R.Fma(mx + my + mz, s.Slack, rounding));
        }

        return worst;
    }
}
