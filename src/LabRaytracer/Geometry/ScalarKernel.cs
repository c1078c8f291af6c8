namespace LabRaytracer;

/// <summary>The calls for one ray of a shape whose formulas are a kernel: the same formulas with one lane.</summary>
/// <typeparam name="K">The kernel.</typeparam>
internal static unsafe class ScalarKernel<K>
    where K : struct, IShapeKernel
{
    /// <summary><see cref="Shape.Intersect"/> by the kernel.</summary>
    public static bool Intersect(Shape shape, in Ray ray, double limit, out Hit hit)
    {
        double* numbers = stackalloc double[K.ParameterCount];
        SharedParameters<Double1, Float1, Int1> described = Describe(shape, numbers);
        RayLanes<Double1> lanes = Lanes(ray);
        bool isHit = Double1.Any(K.Intersect(described, lanes, out Double1 t)) && t.Value < limit;
        hit = new Hit(isHit ? K.Refine(described, lanes, t).Value : t.Value);
        return isHit;
    }

    /// <summary><see cref="Shape.SurfaceAt"/> by the kernel.</summary>
    public static SurfacePoint SurfaceAt(Shape shape, in Ray ray, in Hit hit)
    {
        double* numbers = stackalloc double[K.ParameterCount];
        Double1 t = new(hit.T);
        K.Surface(Describe(shape, numbers), Lanes(ray), ref t, out SurfaceLanes<Double1> s);
        return new SurfacePoint(
            new Point3D(s.PointX.Value, s.PointY.Value, s.PointZ.Value),
            new Vector3D(s.NormalX.Value, s.NormalY.Value, s.NormalZ.Value),
            new Vector3D(s.ShadingX.Value, s.ShadingY.Value, s.ShadingZ.Value),
            new SurfacePosition(
                new Point3D(s.LocalX.Value, s.LocalY.Value, s.LocalZ.Value),
                new Vector3D(s.LocalNormalX.Value, s.LocalNormalY.Value, s.LocalNormalZ.Value),
                new TextureCoordinate(s.SurfaceU.Value, s.SurfaceV.Value)),
            s.Slack.Value);
    }

    private static SharedParameters<Double1, Float1, Int1> Describe(Shape shape, double* numbers)
    {
        K.Describe(shape, Transform.Identity, new Span<double>(numbers, K.ParameterCount));
        return new SharedParameters<Double1, Float1, Int1>((Double1*)numbers, 0);
    }

    private static RayLanes<Double1> Lanes(in Ray ray) => new(
        new Double1(ray.Origin.X), new Double1(ray.Origin.Y), new Double1(ray.Origin.Z),
        new Double1(ray.Direction.X), new Double1(ray.Direction.Y), new Double1(ray.Direction.Z));
}
