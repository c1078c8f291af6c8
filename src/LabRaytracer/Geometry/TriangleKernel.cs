using System.Runtime.CompilerServices;

namespace LabRaytracer;

/// <summary>The formulas of <see cref="Triangle"/>: three vertices, the unit normal, three shading normals, three texture coordinates.</summary>
internal readonly struct TriangleKernel : IShapeKernel
{
    private const int Vertex = 0, Normal = 9, Shading = 12, Texture = 21;

    public static int ParameterCount => 27;

    public static bool IsConvex => true;

    public static bool IsCurved => true;

    public static void Describe(Shape shape, Transform transform, Span<double> numbers)
    {
        Triangle triangle = (Triangle)shape;
        ReadOnlySpan<Point3D> vertices = [triangle.A, triangle.B, triangle.C];
        for (int i = 0; i < 3; i++)
        {
            Put(numbers[(Vertex + (3 * i))..], vertices[i].ToVector());
            Put(numbers[(Shading + (3 * i))..], triangle.VertexNormals[i]);
            numbers[Texture + (2 * i)] = triangle.VertexCoordinates[i].U;
            numbers[Texture + (2 * i) + 1] = triangle.VertexCoordinates[i].V;
        }

        Put(numbers[Normal..], triangle.Normal);
    }

    [MethodImpl(MethodImplOptions.NoInlining)]
    public static R Intersect<R, P>(in P shape, in RayLanes<R> ray, out R t)
        where R : unmanaged, IReal<R>
        where P : struct, IParameters<R> => Weights(shape, ray, out t, out _, out _, out _);

    [MethodImpl(MethodImplOptions.NoInlining)]
    public static void Surface<R, P>(in P shape, in RayLanes<R> ray, ref R t, out SurfaceLanes<R> s)
        where R : unmanaged, IReal<R>
        where P : struct, IParameters<R>
    {
        Weights(shape, ray, out _, out R a, out R b, out R c);
        s = default;
        s.NormalX = s.LocalNormalX = shape[Normal];
        s.NormalY = s.LocalNormalY = shape[Normal + 1];
        s.NormalZ = s.LocalNormalZ = shape[Normal + 2];
        s.LocalX = s.PointX = Mix(shape, Vertex, 3, a, b, c);
        s.LocalY = s.PointY = Mix(shape, Vertex + 1, 3, a, b, c);
        s.LocalZ = s.PointZ = Mix(shape, Vertex + 2, 3, a, b, c);
        s.SurfaceU = Mix(shape, Texture, 2, a, b, c);
        s.SurfaceV = Mix(shape, Texture + 1, 2, a, b, c);
        R x = Mix(shape, Shading, 3, a, b, c);
        R y = Mix(shape, Shading + 1, 3, a, b, c);
        R z = Mix(shape, Shading + 2, 3, a, b, c);

        // Normals that cancel have no direction between them: the flat one stands in.
        R lengthSquared = Lane.Dot(x, y, z, x, y, z);
        R exists = R.Less(R.Of(1e-12), lengthSquared);
        R toUnit = R.Of(1) / R.Sqrt(lengthSquared);
        s.ShadingX = R.Select(exists, x * toUnit, s.NormalX);
        s.ShadingY = R.Select(exists, y * toUnit, s.NormalY);
        s.ShadingZ = R.Select(exists, z * toUnit, s.NormalZ);
        s.Slack = Lane.Slack(Size<R, P>(shape, 0) + Size<R, P>(shape, 1) + Size<R, P>(shape, 2));
    }

    /// <summary>Weights of the three vertices at the hit, and its ray parameter.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static R Weights<R, P>(in P shape, in RayLanes<R> ray, out R t, out R a, out R b, out R c)
        where R : unmanaged, IReal<R>
        where P : struct, IParameters<R>
    {
        WatertightRay<R> watertight = new(ray);
        R hit = WatertightTriangle.Intersect(
            watertight, shape[0], shape[1], shape[2], shape[3], shape[4], shape[5], shape[6], shape[7], shape[8], out t, out b, out c);
        a = R.Of(1) - b - c;
        return hit;
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static R Mix<R, P>(in P shape, int at, int stride, R a, R b, R c)
        where R : unmanaged, IReal<R>
        where P : struct, IParameters<R> => R.Fma(a, shape[at], R.Fma(b, shape[at + stride], c * shape[at + (2 * stride)]));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static R Size<R, P>(in P shape, int axis)
        where R : unmanaged, IReal<R>
        where P : struct, IParameters<R> =>
        R.Max(R.Max(R.Abs(shape[axis]), R.Abs(shape[axis + 3])), R.Abs(shape[axis + 6]));

    private static void Put(Span<double> numbers, Vector3D value)
    {
        numbers[0] = value.X;
        numbers[1] = value.Y;
        numbers[2] = value.Z;
    }

    public static void LocalFrame<R, P>(in P shape, out LinearLanes<R> frame)
        where R : unmanaged, IReal<R>
        where P : struct, IParameters<R> => frame = LinearLanes<R>.Scaling(R.Of(1), R.Of(1), R.Of(1));

    [MethodImpl(MethodImplOptions.NoInlining)]
    public static void BendNormal<R, P>(in P shape, R x, R y, R z, R stepX, R stepY, R stepZ, out NormalLanes<R> normal)
        where R : unmanaged, IReal<R>
        where P : struct, IParameters<R>
    {
        TriangleGradient<R> weights = Gradient<R, P>(shape);
        R px = x - shape[Vertex], py = y - shape[Vertex + 1], pz = z - shape[Vertex + 2];
        R b = Lane.Dot(weights.SecondX, weights.SecondY, weights.SecondZ, px, py, pz);
        R c = Lane.Dot(weights.ThirdX, weights.ThirdY, weights.ThirdZ, px, py, pz);
        R stepB = Lane.Dot(weights.SecondX, weights.SecondY, weights.SecondZ, stepX, stepY, stepZ);
        R stepC = Lane.Dot(weights.ThirdX, weights.ThirdY, weights.ThirdZ, stepX, stepY, stepZ);
        R a = R.Of(1) - b - c, stepA = -stepB - stepC;
        normal.X = Mix(shape, Shading, 3, a, b, c);
        normal.Y = Mix(shape, Shading + 1, 3, a, b, c);
        normal.Z = Mix(shape, Shading + 2, 3, a, b, c);
        normal.StepX = Mix(shape, Shading, 3, stepA, stepB, stepC);
        normal.StepY = Mix(shape, Shading + 1, 3, stepA, stepB, stepC);
        normal.StepZ = Mix(shape, Shading + 2, 3, stepA, stepB, stepC);
    }

    public static void SurfaceGradient<R, P>(in P shape, out GradientLanes<R> gradient)
        where R : unmanaged, IReal<R>
        where P : struct, IParameters<R>
    {
        TriangleGradient<R> weights = Gradient<R, P>(shape);
        (gradient.UX, gradient.UY, gradient.UZ) = weights.Of(shape[Texture + 2] - shape[Texture], shape[Texture + 4] - shape[Texture]);
        (gradient.VX, gradient.VY, gradient.VZ) = weights.Of(shape[Texture + 3] - shape[Texture + 1], shape[Texture + 5] - shape[Texture + 1]);
    }

    private static TriangleGradient<R> Gradient<R, P>(in P shape)
        where R : unmanaged, IReal<R>
        where P : struct, IParameters<R> => new(
            shape[Vertex + 3] - shape[Vertex], shape[Vertex + 4] - shape[Vertex + 1], shape[Vertex + 5] - shape[Vertex + 2],
            shape[Vertex + 6] - shape[Vertex], shape[Vertex + 7] - shape[Vertex + 1], shape[Vertex + 8] - shape[Vertex + 2]);
}
