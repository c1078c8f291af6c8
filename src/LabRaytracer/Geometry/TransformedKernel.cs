using System.Runtime.CompilerServices;

namespace LabRaytracer;

/// <summary>A kernel behind a transform: rays go to object space, surfaces come back to world space.</summary>
/// <typeparam name="K">The kernel in object space.</typeparam>
/// <remarks>The numbers of <see cref="WorldSpace"/>, then the shape's own.</remarks>
[SkipLocalsInit]
internal readonly struct TransformedKernel<K> : IShapeKernel
    where K : struct, IShapeKernel
{
    public static int ParameterCount => WorldSpace.ParameterCount + K.ParameterCount;

    public static bool IsConvex => K.IsConvex;

    public static bool IsCurved => K.IsCurved;

    public static void Describe(Shape shape, Transform transform, Span<double> numbers)
    {
        WorldSpace.Describe(transform, numbers);
        K.Describe(shape, Transform.Identity, numbers[WorldSpace.ParameterCount..]);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static R Intersect<R, P>(in P shape, in RayLanes<R> ray, out R t)
        where R : unmanaged, IReal<R>
        where P : struct, IParameters<R> =>
        K.Intersect(new OffsetParameters<R, P>(shape, WorldSpace.ParameterCount), WorldSpace.ToObject(shape, ray), out t);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static R Refine<R, P>(in P shape, in RayLanes<R> ray, R t)
        where R : unmanaged, IReal<R>
        where P : struct, IParameters<R> =>
        K.Refine(new OffsetParameters<R, P>(shape, WorldSpace.ParameterCount), WorldSpace.ToObject(shape, ray), t);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void Surface<R, P>(in P shape, in RayLanes<R> ray, ref R t, out SurfaceLanes<R> s)
        where R : unmanaged, IReal<R>
        where P : struct, IParameters<R>
    {
        K.Surface(new OffsetParameters<R, P>(shape, WorldSpace.ParameterCount), WorldSpace.ToObject(shape, ray), ref t, out s);
        WorldSpace.FromObject(shape, ref s);
    }

    /// <remarks>t is that of the ray in object space, whose numbers are rounded.</remarks>
    [MethodImpl(MethodImplOptions.NoInlining)]
    public static void Sharpen<R, P>(in P shape, in RayLanes<R> ray, ref R t, ref SurfaceLanes<R> s)
        where R : unmanaged, IReal<R>
        where P : struct, IParameters<R>
    {
        OffsetParameters<R, P> own = new(shape, WorldSpace.ParameterCount);
        RayLanes<R> objectRay = WorldSpace.ToObject(shape, ray);
        K.Surface(own, objectRay, ref t, out s);
        K.Sharpen(own, objectRay, ref t, ref s);
        WorldSpace.FromObject(shape, ref s);
    }

    public static void LocalFrame<R, P>(in P shape, out LinearLanes<R> frame)
        where R : unmanaged, IReal<R>
        where P : struct, IParameters<R>
    {
        K.LocalFrame(new OffsetParameters<R, P>(shape, WorldSpace.ParameterCount), out LinearLanes<R> local);
        WorldSpace.Linear(shape, out LinearLanes<R> toObject);
        (frame.XX, frame.XY, frame.XZ) = toObject.ApplyTransposed(local.XX, local.XY, local.XZ);
        (frame.YX, frame.YY, frame.YZ) = toObject.ApplyTransposed(local.YX, local.YY, local.YZ);
        (frame.ZX, frame.ZY, frame.ZZ) = toObject.ApplyTransposed(local.ZX, local.ZY, local.ZZ);
    }

    public static void BendNormal<R, P>(in P shape, R x, R y, R z, R stepX, R stepY, R stepZ, out NormalLanes<R> normal)
        where R : unmanaged, IReal<R>
        where P : struct, IParameters<R> =>
        K.BendNormal(new OffsetParameters<R, P>(shape, WorldSpace.ParameterCount), x, y, z, stepX, stepY, stepZ, out normal);

    public static void SurfaceGradient<R, P>(in P shape, out GradientLanes<R> gradient)
        where R : unmanaged, IReal<R>
        where P : struct, IParameters<R> =>
        K.SurfaceGradient(new OffsetParameters<R, P>(shape, WorldSpace.ParameterCount), out gradient);
}
