using LabRaytracer.Tests.Geometry;
using LabRaytracer.Tests.Rendering;

namespace LabRaytracer.Tests.Cameras;

/// <summary>Cameras with a lens, and the fisheye.</summary>
public sealed class LensTests
{
    private static readonly PerspectiveCamera s_pinhole = new(new Point3D(1, 2, 3), new Point3D(-2, 0.5, -4), 50);

    private static Vector3D Forward => (s_pinhole.Target - s_pinhole.Eye).Normalized();

    [Fact]
    public void LensOfRadiusZero_IsThePinhole_BitForBit()
    {
        ThinLensCamera camera = new(s_pinhole, 0, 7);
        Assert.False(camera.HasLens);
        Assert.Equal(s_pinhole.RayAt(12.5, 7.25, 70, 50), camera.RayAt(12.5, 7.25, new SquarePoint(0.9, 0.2), 70, 50));
        Scene scene = TestScenes.Everything();
        PerspectiveCamera hole = new(new Point3D(0.3, 1.4, 5), new Point3D(0, 0.3, 0), 45);
        scene.Camera = hole;
        RenderOptions options = new() { Width = 40, Height = 30, Samples = 4, Threads = 1 };
        Picture expected = Renderer.Render(scene, options).Picture;
        scene.Camera = new ThinLensCamera(hole, 0);
        PictureAssert.SameBits(expected, Renderer.Render(scene, options).Picture);
    }

    [Theory]
    [InlineData(0.5, 0.5, 5)]
    [InlineData(31.5, 12.25, 5)]
    [InlineData(69, 49, 0.3)]
    public void AllRaysOfAPoint_MeetInThePlaneOfFocus(double x, double y, double focus)
    {
        ThinLensCamera camera = new(s_pinhole, 0.25, focus);
        Ray middle = s_pinhole.RayAt(x, y, 70, 50);
        Point3D meeting = middle.Origin + (middle.Direction * (focus / Vector3D.Dot(middle.Direction, Forward)));
        foreach ((double s, double t) in new[] { (0, 0), (0.5, 0.5), (0.1, 0.8), (0.999, 0.3), (0.5, 0.01) })
        {
            Ray ray = camera.RayAt(x, y, new SquarePoint(s, t), 70, 50);
            Vector3D offset = ray.Origin - s_pinhole.Eye;
            Assert.InRange(offset.Length, 0, 0.25 + 1e-15);
            Assert.Equal(0, Vector3D.Dot(offset, Forward), 1e-15);
            Assert.Equal(1, ray.Direction.Length, 4e-16);
            double reach = focus / Vector3D.Dot(ray.Direction, Forward);
            Assert.Equal(0, (ray.Origin + (ray.Direction * reach) - meeting).Length, 4e-15);
        }
    }

    [Theory]
    [InlineData(2)]
    [InlineData(4)]
    [InlineData(40)]
    public void CircleOfConfusion_HasTheRadiusOfTheFormula(double distance)
    {
        // On the axis, at distance z, the rays of a pixel fill a disk of radius r |1 - z / F|: seen from the eye on the plane of focus r |1 - F / z|.
        const double Radius = 0.25, Focus = 4;
        ThinLensCamera camera = new(s_pinhole, Radius, Focus);
        double largest = 0, squares = 0;
        for (int i = 0; i < 1024; i++)
        {
            Ray ray = camera.RayAt(35, 25, new SquarePoint(((i % 32) + 0.5) / 32, ((i / 32) + 0.5) / 32), 70, 50);
            Point3D at = ray.Origin + (ray.Direction * (distance / Vector3D.Dot(ray.Direction, Forward)));
            double offset = (at - (s_pinhole.Eye + (Forward * distance))).Length;
            largest = Math.Max(largest, offset);
            squares += offset * offset / 1024;
        }

        double expected = Radius * Math.Abs(1 - (distance / Focus));
        Assert.InRange(largest, expected * 0.95, expected + 1e-12);

        // A disk that is evenly filled has the mean square R^2 / 2.
        Assert.Equal(expected * expected / 2, squares, (expected * expected / 500) + 1e-24);
    }

    [Fact]
    public void PictureInThePlaneOfFocus_IsSharpWithOneSample()
    {
        Texture texture = TestScenes.Random(9, 9);
        PerspectiveCamera hole = new(new Point3D(0, 3, 0), Point3D.Origin, 30, Vector3D.UnitX);
        Scene scene = TestScenes.QuadFromAbove(TestScenes.Shining(texture));
        scene.Camera = hole;
        Picture sharp = TestScenes.Render(scene, 40, 30);
        scene.Camera = new ThinLensCamera(hole, 0.5);
        Picture lens = TestScenes.Render(scene, 40, 30);
        Assert.InRange(PictureDifference.Compare(sharp, lens).Max, 0, 1e-5);
        scene.Camera = new ThinLensCamera(hole, 0.5, 2);
        Assert.InRange(PictureDifference.Compare(sharp, TestScenes.Render(scene, 40, 30)).Max, 0.1, 1);
    }

    [Fact]
    public void LensOfOnesOwn_IsAskedForEachSample()
    {
        var scene = new Scene { Camera = new Shutter(), Background = new TextureSlot { Texture = new Texture(new[,] { { Intensity.Black, Intensity.White } }) } };
        Picture Render(int samples) => Renderer.Render(scene, new RenderOptions { Width = 8, Height = 8, Samples = samples, Threads = 1 }).Picture;
        Assert.All(Render(4).Pixels.ToArray(), pixel => Assert.Equal(0.5f, pixel.R));
        Assert.Equal([0f, 1f], Render(1).Pixels.ToArray().Select(pixel => pixel.R).Distinct().Order());
    }

    [Theory]
    [InlineData(SamplePattern.Regular)]
    [InlineData(SamplePattern.Jittered)]
    [InlineData(SamplePattern.Sobol)]
    [InlineData(SamplePattern.MultiJittered)]
    public void PlacesOnTheLens_HaveNothingToDoWithPlacesInThePixel(SamplePattern pattern)
    {
        // Up where exactly one of both lies in the left half: one half of the samples, if they are independent. Samples come in pairs of
        // opposite halves: 128 independent pairs have a deviation of 1 / sqrt(512). Dependence would show as 0 or 1.
        var scene = new Scene { Camera = new Both(), Background = new TextureSlot { Texture = new Texture(new[,] { { Intensity.Black, Intensity.White } }) } };
        Picture picture = Renderer.Render(scene, new RenderOptions { Width = 16, Height = 16, Samples = 256, Pattern = pattern, Threads = 1 }).Picture;
        Assert.All(picture.Pixels.ToArray(), pixel => Assert.InRange(pixel.R, 0.5 - (5 / Math.Sqrt(512)), 0.5 + (5 / Math.Sqrt(512))));
        Assert.Equal(0.5f, picture.Pixels.ToArray().Average(pixel => pixel.R), 4 / (16 * MathF.Sqrt(512)));
    }

    [Fact]
    public void Spread_AnyWidth_SameBitsAsOneRay() => new WideTest().RunAllDoubles();

    [Theory]
    [InlineData(Precision.Double)]
    [InlineData(Precision.Single)]
    public void Render_AnyThreadsAndWidths_SameBits(Precision precision)
    {
        Scene scene = TestScenes.Everything();
        scene.Camera = new ThinLensCamera((PerspectiveCamera)scene.Camera, 0.1);
        Picture Render(int laneWidth, int threads) => Renderer.Render(
            scene, new RenderOptions { Width = 41, Height = 37, Threads = threads, Precision = precision, Samples = 4 }, laneWidth, null, default).Picture;
        Picture narrow = Render(1, 1);
        PictureAssert.SameBits(narrow, Render(4, 2));
        PictureAssert.SameBits(narrow, Render(8, 1));
        PictureAssert.SameBits(narrow, Render(16, 3));
    }

    [Theory]
    [InlineData(50, 50, 0, 0, -1)]
    [InlineData(50, 0, 0, 1, 0)]
    [InlineData(50, 100, 0, -1, 0)]
    [InlineData(100, 50, 1, 0, 0)]
    [InlineData(25, 50, -0.70710678118654752, 0, -0.70710678118654752)]
    [InlineData(200, 50, 0, 0, 1)]
    public void Fisheye_AngleIsInProportionToTheDistanceFromTheMiddle(double x, double y, double dx, double dy, double dz)
    {
        // 180 degrees from top to bottom of 100 pixels.
        Ray ray = new FisheyeCamera(Point3D.Origin, new Point3D(0, 0, -2), 180).RayAt(x, y, 100, 100);
        Assert.Equal(0, (ray.Direction - new Vector3D(dx, dy, dz)).Length, 4e-16);
    }

    [Fact]
    public void Constructor_BadArguments_SaysWhatIsAllowed()
    {
        Assert.Throws<ArgumentOutOfRangeException>(() => new ThinLensCamera(s_pinhole, -1));
        Assert.Throws<ArgumentOutOfRangeException>(() => new ThinLensCamera(s_pinhole, double.NaN));
        Assert.Throws<ArgumentOutOfRangeException>(() => new ThinLensCamera(s_pinhole, 1, 0));
        Assert.Throws<ArgumentNullException>(() => new ThinLensCamera(null!, 1));
        Assert.Throws<ArgumentOutOfRangeException>(() => new FisheyeCamera(Point3D.Origin, new Point3D(0, 0, 1), 361));
        Assert.Throws<ArgumentOutOfRangeException>(() => new FisheyeCamera(Point3D.Origin, Point3D.Origin, 180));
    }

    /// <summary>Looks up where one of both, place on the lens and place in the pixel, lies in its left half, else down.</summary>
    private sealed class Both : Camera
    {
        public override bool HasLens => true;

        public override Ray RayAt(double x, double y, int width, int height) => throw new NotSupportedException();

        public override Ray RayAt(double x, double y, SquarePoint lens, int width, int height) =>
            new(Point3D.Origin, (lens.S < 0.5) ^ (x - Math.Floor(x) < 0.5) ? Vector3D.UnitY : -Vector3D.UnitY);

        public override RayDifferential DifferentialAt(double x, double y, int width, int height) => default;
    }

    /// <summary>Half of its lens looks up, half down.</summary>
    private sealed class Shutter : Camera
    {
        public override bool HasLens => true;

        public override Ray RayAt(double x, double y, int width, int height) => throw new NotSupportedException();

        public override Ray RayAt(double x, double y, SquarePoint lens, int width, int height) => new(Point3D.Origin, lens.S < 0.5 ? Vector3D.UnitY : -Vector3D.UnitY);

        public override RayDifferential DifferentialAt(double x, double y, int width, int height) => default;
    }

    private sealed unsafe class WideTest : ILaneTest
    {
        public void Run<R, F, I>()
            where R : unmanaged, ILane<R, F, I>
            where F : unmanaged, ILane<F, F, I>
            where I : unmanaged, IIndexLane<I>
        {
            ThinLensCamera camera = new(s_pinhole, 0.3, 2.5);
            using LaneMemory memory = new();
            R* numbers = memory.Column<R>(4 * 48, R.Width);
            int step = 48 / R.Width;
            R* x = numbers, y = numbers + step, s = numbers + (2 * step), t = numbers + (3 * step);
            RayBatch<R, F, I> rays = new(memory, 48, hasDifferentials: false);
            for (int i = 0; i < 48; i++)
            {
                R.Put(x, i, i * 1.37);
                R.Put(y, i, 47.5 - (i * 0.91));
                R.Put(s, i, i / 48.0);
                R.Put(t, i, i * 29 % 48 / 48.0);
            }

            ((IWideCamera)camera).Rays(x, y, rays.Columns, step, 70, 50);
            ((IWideLensCamera)camera).Spread(s, t, rays.Columns, step);
            for (int i = 0; i < 48; i++)
            {
                Assert.Equal(camera.RayAt(i * 1.37, 47.5 - (i * 0.91), new SquarePoint(i / 48.0, i * 29 % 48 / 48.0), 70, 50), rays[i]);
            }
        }
    }
}
