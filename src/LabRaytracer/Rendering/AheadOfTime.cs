namespace LabRaytracer;

/// <summary>Names the code that a render reaches only through virtual generic methods, for compilers that run ahead of time (ReadyToRun).</summary>
/// <remarks>Never called: such a compiler starts at what it finds named, and does not look behind a virtual generic call. What is not named here is compiled at run time.</remarks>
internal static class AheadOfTime
{
    internal static void Name()
    {
        Name<Double16, Float16, Int16>();
        Name<Float16, Float16, Int16>();
        Name<Double8, Float8, Int8>();
        Name<Float8, Float8, Int8>();
    }

    private static void Name<TReader, R, F, I>()
        where TReader : struct, ITexelReader
        where R : unmanaged, ILane<R, F, I>
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I> =>
        new PictureSampler<TReader>(null!, null, default, SamplingOptions.Default, TextureFilter.Nearest).Run<R, F, I>(default, default, 0);

    private static void Name<R, F, I>()
        where R : unmanaged, ILane<R, F, I>
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I>
    {
        Transform transform = Transform.Identity;
        KernelGroups.Create<SphereKernel, R, F, I>(transform);
        KernelGroups.Create<PlaneKernel, R, F, I>(transform);
        KernelGroups.Create<CylinderKernel, R, F, I>(transform);
        KernelGroups.Create<BoxKernel, R, F, I>(transform);
        KernelGroups.Create<FlatKernel<SquareOutline>, R, F, I>(transform);
        KernelGroups.Create<FlatKernel<CircleOutline>, R, F, I>(transform);
        KernelGroups.Create<TriangleKernel, R, F, I>(transform);
        _ = new MeshGroup<R, F, I>(isTransformed: false);
        PointFormulas.Map<SphericalMapping.Formula, R>(default, default, 0);
        PointFormulas.Map<RectangularMapping.Formula, R>(default, default, 0);
        PointFormulas.Map<CylindricalMapping.Formula, R>(default, default, 0);
        new PointLight(Point3D.Origin, Intensity.White).Shine<R, F, I>(null!, default, 0);
        PhongShader.Formula(default, out F _, out F _, out F _);
        unsafe
        {
            new PerspectiveCamera(Point3D.Origin, new Point3D(0, 0, -1), 40).Aim<R>(null, null, default, 0, 1, 1);
        }

        Name<Linear8Reader, R, F, I>();
        Name<Table8Reader, R, F, I>();
        Name<FloatReader, R, F, I>();
        Name<PackedLinearReader, R, F, I>();
        Name<PackedTableReader, R, F, I>();
    }
}
