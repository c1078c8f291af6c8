namespace LabRaytracer.Tests.Rendering;

/// <summary>The expensive digits of a hit are computed at most once, for what is seen and for nothing else.</summary>
public sealed class RefinementTests
{
    [Theory]
    [InlineData(Precision.Double)]
    [InlineData(Precision.Exact)]
    public void SpheresBehindSpheres_EachVisibleHitIsRefinedAtMostOnce(Precision precision)
    {
        Scene scene = Row(out CountedSphere counted);
        RenderOptions options = new() { Width = 48, Height = 48, Threads = 1, Precision = precision };
        RenderStatistics statistics = Renderer.Render(scene, options, 1, null, default).Statistics;

        // The sphere around everything leaves no ray without a hit.
        Assert.Equal(statistics.PrimaryRays + statistics.SecondaryRays, statistics.Hits);
        Assert.True(statistics.SecondaryRays > 500);
        Assert.InRange(statistics.HitsRefined, 1, statistics.Hits);
        Assert.Equal(statistics.Hits, counted.Surfaces);
        Assert.Equal(precision == Precision.Exact ? statistics.Hits : 0, counted.Sharpened);

        // Others were looked at and hidden, though the search leaves most of them out.
        Assert.True(counted.Candidates > statistics.Hits);
    }

    [Fact]
    public void Exact_AnyLaneWidth_SameCountsAndSameBits()
    {
        RenderOptions options = new() { Width = 48, Height = 48, Threads = 1, Precision = Precision.Exact, View = RenderView.Depth };
        RenderResult one = Renderer.Render(Row(out _), options, 1, null, default);
        foreach (int width in new[] { 4, 8, 16 })
        {
            RenderResult wide = Renderer.Render(Row(out _), options, width, null, default);
            PictureAssert.SameBits(one.Picture, wide.Picture);
            Assert.Equal((one.Statistics.Hits, one.Statistics.HitsRefined), (wide.Statistics.Hits, wide.Statistics.HitsRefined));
        }
    }

    [Fact]
    public void Exact_ColoursOfAnOrdinaryScene_StayWithinOneUnitOfTheFloats()
    {
        Scene scene = TestScenes.Everything();
        RenderOptions options = new() { Width = 64, Height = 48, Threads = 1 };
        Picture usual = Renderer.Render(scene, options).Picture;
        Picture exact = Renderer.Render(scene, new RenderOptions { Width = 64, Height = 48, Threads = 1, Precision = Precision.Exact }).Picture;
        PictureAssert.Near(usual, exact, 1e-6);
    }

    /// <summary>Mirrors in a row, each hiding the next, in a sphere around everything.</summary>
    private static Scene Row(out CountedSphere counted)
    {
        Counts counts = new();
        var scene = new Scene { Camera = new PerspectiveCamera(new Point3D(0, 0, -4), Point3D.Origin, 40) };
        var mirror = new Material { Reflection = Intensity.Grey(0.5f) };
        for (int i = 0; i < 6; i++)
        {
            scene.Add(new CountedSphere(new Point3D(0.05 * i, 0, 3 * i), 1, counts), mirror);
        }

        counted = new CountedSphere(Point3D.Origin, 100, counts);
        scene.Add(counted, TestScenes.Shining(Intensity.White));
        return scene;
    }

    /// <summary>What the kernel of a render was asked; one render at a time on one thread.</summary>
    private sealed class Counts
    {
        [ThreadStatic]
        public static Counts? Current;

        public int Candidates, Surfaces, Sharpened;
    }

    /// <summary>A sphere that counts.</summary>
    private sealed class CountedSphere(Point3D center, double radius, Counts counts) : Shape
    {
        private readonly Sphere _sphere = new(center, radius);

        public int Candidates => counts.Candidates;

        public int Surfaces => counts.Surfaces;

        public int Sharpened => counts.Sharpened;

        public Sphere Sphere => _sphere;

        public override Bounds Bounds => _sphere.Bounds;

        public override IMapping DefaultMapping => _sphere.DefaultMapping;

        public override bool Intersect(in Ray ray, double limit, out Hit hit) => _sphere.Intersect(ray, limit, out hit);

        public override SurfacePoint SurfaceAt(in Ray ray, in Hit hit) => _sphere.SurfaceAt(ray, hit);

        internal override ShapeGroup<R, F, I> CreateGroup<R, F, I>(Transform transform)
        {
            Counts.Current = counts;
            return new KernelGroup<CountingKernel, R, F, I>();
        }
    }

    private readonly struct CountingKernel : IShapeKernel
    {
        public static int ParameterCount => SphereKernel.ParameterCount;

        public static void Describe(Shape shape, Transform transform, Span<double> numbers) =>
            SphereKernel.Describe(((CountedSphere)shape).Sphere, transform, numbers);

        public static R Intersect<R, P>(in P shape, in RayLanes<R> ray, out R t)
            where R : unmanaged, IReal<R>
            where P : struct, IParameters<R>
        {
            Counts.Current!.Candidates++;
            return SphereKernel.Intersect(shape, ray, out t);
        }

        public static void Surface<R, P>(in P shape, in RayLanes<R> ray, ref R t, out SurfaceLanes<R> s)
            where R : unmanaged, IReal<R>
            where P : struct, IParameters<R>
        {
            Counts.Current!.Surfaces++;
            SphereKernel.Surface(shape, ray, ref t, out s);
        }

        public static void Sharpen<R, P>(in P shape, in RayLanes<R> ray, ref R t, ref SurfaceLanes<R> s)
            where R : unmanaged, IReal<R>
            where P : struct, IParameters<R>
        {
            Counts.Current!.Sharpened++;
            SphereKernel.Sharpen(shape, ray, ref t, ref s);
        }

        public static void LocalFrame<R, P>(in P shape, out LinearLanes<R> frame)
            where R : unmanaged, IReal<R>
            where P : struct, IParameters<R> => SphereKernel.LocalFrame(shape, out frame);
    }
}
