using System.Runtime.CompilerServices;

namespace LabRaytracer;

/// <summary>The way of rays to object space and of surfaces back to world space.</summary>
/// <remarks>The parameters begin with the 12 numbers world to object, then the 12 numbers object to world, row after row.</remarks>
internal static class WorldSpace
{
    /// <summary>How many numbers describe a transform.</summary>
    public const int ParameterCount = 24;

    private const int ObjectFromWorld = 0, WorldFromObject = 12;

    /// <summary>Writes the numbers of a transform.</summary>
    public static void Describe(Transform transform, Span<double> numbers)
    {
        transform.ObjectFromWorldRows.CopyTo(numbers[ObjectFromWorld..]);
        transform.WorldFromObjectRows.CopyTo(numbers[WorldFromObject..]);
    }

    /// <summary>Rays in object space; the direction keeps the ray parameter. The bits of <see cref="Transform.ObjectFromWorld(in Ray)"/>.</summary>
    [MethodImpl(MethodImplOptions.NoInlining)]
    public static RayLanes<R> ToObject<R, P>(in P m, in RayLanes<R> ray)
        where R : unmanaged, IReal<R>
        where P : struct, IParameters<R> => new(
            Row(m, ObjectFromWorld, ray.OriginX, ray.OriginY, ray.OriginZ) + m[ObjectFromWorld + 3],
            Row(m, ObjectFromWorld + 4, ray.OriginX, ray.OriginY, ray.OriginZ) + m[ObjectFromWorld + 7],
            Row(m, ObjectFromWorld + 8, ray.OriginX, ray.OriginY, ray.OriginZ) + m[ObjectFromWorld + 11],
            Row(m, ObjectFromWorld, ray.DirectionX, ray.DirectionY, ray.DirectionZ),
            Row(m, ObjectFromWorld + 4, ray.DirectionX, ray.DirectionY, ray.DirectionZ),
            Row(m, ObjectFromWorld + 8, ray.DirectionX, ray.DirectionY, ray.DirectionZ));

    /// <summary>Takes point, normals and slack to world space; what mappings see stays as it is.</summary>
    [MethodImpl(MethodImplOptions.NoInlining)]
    public static void FromObject<R, P>(in P m, ref SurfaceLanes<R> s)
        where R : unmanaged, IReal<R>
        where P : struct, IParameters<R>
    {
        R x = Row(m, WorldFromObject, s.PointX, s.PointY, s.PointZ) + m[WorldFromObject + 3];
        R y = Row(m, WorldFromObject + 4, s.PointX, s.PointY, s.PointZ) + m[WorldFromObject + 7];
        R z = Row(m, WorldFromObject + 8, s.PointX, s.PointY, s.PointZ) + m[WorldFromObject + 11];
        R slack = OutwardSlack(m, s);

        // A secondary ray comes back through the inverse: its rounding there, measured along the normal, must not lead below the surface either.
        R back = ReturnSlack(m, x, y, z, s);
        (s.PointX, s.PointY, s.PointZ) = (x, y, z);
        R stretch = Normal(m, ref s.NormalX, ref s.NormalY, ref s.NormalZ);
        Normal(m, ref s.ShadingX, ref s.ShadingY, ref s.ShadingZ);
        s.Slack = R.Fma(back, stretch, slack);
    }

    /// <summary>The object-space slack and the rounding of the transform, through the absolute values of the matrix.</summary>
    [MethodImpl(MethodImplOptions.NoInlining)]
    private static R OutwardSlack<R, P>(in P m, in SurfaceLanes<R> s)
        where R : unmanaged, IReal<R>
        where P : struct, IParameters<R>
    {
        R worst = R.Zero;
        for (int row = WorldFromObject; row < WorldFromObject + 12; row += 4)
        {
            R stretch = R.Abs(m[row]) + R.Abs(m[row + 1]) + R.Abs(m[row + 2]);
            worst = R.Max(worst, R.Fma(stretch, s.Slack, Lane.Slack(Size(m, row, s.PointX, s.PointY, s.PointZ))));
        }

        return worst;
    }

    /// <summary>The rounding of a world-space point on its way to object space, along the normal there; an eighth of the margin is enough for one product.</summary>
    [MethodImpl(MethodImplOptions.NoInlining)]
    private static R ReturnSlack<R, P>(in P m, R x, R y, R z, in SurfaceLanes<R> s)
        where R : unmanaged, IReal<R>
        where P : struct, IParameters<R> => R.Of(0.125) * Lane.Slack(Lane.Dot(
            R.Abs(s.NormalX), R.Abs(s.NormalY), R.Abs(s.NormalZ),
            Size(m, ObjectFromWorld, x, y, z), Size(m, ObjectFromWorld + 4, x, y, z), Size(m, ObjectFromWorld + 8, x, y, z)));

    /// <summary>The largest that one coordinate of a transformed point can be before its terms cancel.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static R Size<R, P>(in P m, int row, R x, R y, R z)
        where R : unmanaged, IReal<R>
        where P : struct, IParameters<R> =>
        Lane.Dot(R.Abs(m[row]), R.Abs(m[row + 1]), R.Abs(m[row + 2]), R.Abs(x), R.Abs(y), R.Abs(z)) + R.Abs(m[row + 3]);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static R Row<R, P>(in P m, int at, R x, R y, R z)
        where R : unmanaged, IReal<R>
        where P : struct, IParameters<R> => R.Fma(m[at], x, R.Fma(m[at + 1], y, m[at + 2] * z));

    /// <summary>Normals map with the inverse transpose, the columns of the matrix world to object. Returns 1 / (length before it is made 1).</summary>
    [MethodImpl(MethodImplOptions.NoInlining)]
    private static R Normal<R, P>(in P m, ref R x, ref R y, ref R z)
        where R : unmanaged, IReal<R>
        where P : struct, IParameters<R>
    {
        R worldX = Lane.Dot(m[ObjectFromWorld], m[ObjectFromWorld + 4], m[ObjectFromWorld + 8], x, y, z);
        R worldY = Lane.Dot(m[ObjectFromWorld + 1], m[ObjectFromWorld + 5], m[ObjectFromWorld + 9], x, y, z);
        R worldZ = Lane.Dot(m[ObjectFromWorld + 2], m[ObjectFromWorld + 6], m[ObjectFromWorld + 10], x, y, z);
        R toUnit = R.Of(1) / R.Sqrt(Lane.Dot(worldX, worldY, worldZ, worldX, worldY, worldZ));
        x = worldX * toUnit;
        y = worldY * toUnit;
        z = worldZ * toUnit;
        return toUnit;
    }

    /// <summary>The linear part of the map from world space to object space.</summary>
    public static void Linear<R, P>(in P m, out LinearLanes<R> toObject)
        where R : unmanaged, IReal<R>
        where P : struct, IParameters<R> => toObject = new LinearLanes<R>
        {
            XX = m[ObjectFromWorld], XY = m[ObjectFromWorld + 1], XZ = m[ObjectFromWorld + 2],
            YX = m[ObjectFromWorld + 4], YY = m[ObjectFromWorld + 5], YZ = m[ObjectFromWorld + 6],
            ZX = m[ObjectFromWorld + 8], ZY = m[ObjectFromWorld + 9], ZZ = m[ObjectFromWorld + 10],
        };
}
