using LabRaytracer.Tests.Geometry;
using LabRaytracer.Tests.Rendering;

namespace LabRaytracer.Tests.Lighting;

/// <summary>Flat lamps: light in closed form, geometry of soft shadows, the wide path against the single one.</summary>
public sealed class QuadLightTests
{
    /// <summary>2 x 1 units at a height, shining down.</summary>
    private static QuadLight Above(double height, int samples = 16, LightSides sides = LightSides.Front) =>
        new(new Point3D(-1, height, -0.5), Vector3D.UnitZ, 2 * Vector3D.UnitX, new Intensity(1, 2, 0.5f)) { Samples = samples, Sides = sides };

    [Theory]
    [InlineData(0, 0, 1, 0.360737482246159938)]
    [InlineData(0, 0, 0.5, 0.66950003965753507)]
    [InlineData(0.75, 0.25, 1, 0.258635185571295111)]
    [InlineData(0.75, 0.25, 0.5, 0.477433840356037409)]
    [InlineData(2, -1, 1, 0.0245601577429336262)]
    [InlineData(2, -1, 0.5, 0.00935873670398703634)]
    [InlineData(-1, 0.5, 1, 0.167375009914383767)]
    [InlineData(-1, 0.5, 0.5, 0.220777622334761586)]
    public void Plane_UnderAParallelRectangle_HasTheFormFactorAsBrightness(double x, double z, double height, double formFactor)
    {
        // Form factor of a surface element to a parallel rectangle (four corner terms, mpmath, checked by numerical integration). 4096 samples
        // of a (0, 2)-sequence: error of order log2(4096) / 4096 of the variation, which is less than the value here.
        Intensity seen = Seen(x, z, Above(height, samples: 4096));
        Assert.InRange(seen.R / (0.5 * formFactor), 1 - (12 / 4096.0), 1 + (12 / 4096.0));
        Assert.Equal(2 * seen.R, seen.G, 1e-6f);
    }

    [Fact]
    public void OneSample_LiesInTheMiddle()
    {
        // k_d L A cos^2 / (pi d^2): d = 2 sqrt(1.25), cos = 1 / sqrt(1.25) at (0, -2, 1) below the middle.
        Intensity seen = Seen(0, 1, Above(2, samples: 1));
        Assert.Equal(0.5 * 2 * 0.8 / (Math.PI * 5), seen.R, 1e-7);
        Assert.True(Above(2).TrySample(new Point3D(0, 0, 1), out LightSample sample));
        Assert.Equal(Math.Sqrt(5), sample.Distance, 1e-15);
        Assert.Equal(2 * Math.Sqrt(0.8) / (Math.PI * 5), sample.Intensity.R, 1e-7);
    }

    [Fact]
    public void FarAway_IsAPointLightOfItsAreaOverPi()
    {
        QuadLight light = Above(1000);
        PointLight point = new(new Point3D(0, 1000, 0), light.Radiance * (float)(2 / Math.PI)) { Attenuation = new Attenuation(0, 0, 1) };
        light.TrySample(Point3D.Origin, new SquarePoint(0.9, 0.1), out LightSample sample);
        point.TrySample(Point3D.Origin, out LightSample expected);
        Assert.Equal(expected.Distance, sample.Distance, 1e-3);
        Assert.Equal(1, sample.Intensity.R / expected.Intensity.R, 4e-6f);
    }

    [Fact]
    public void Sides_FrontOrBoth()
    {
        var behind = new Point3D(0, 3, 0);
        Assert.False(Above(1).TrySample(behind, out LightSample none));
        Assert.Equal(Intensity.Black, none.Intensity);
        Assert.True(Above(1, sides: LightSides.Both).TrySample(behind, out LightSample back));
        Assert.True(Above(1).TrySample(new Point3D(0, -1, 0), out LightSample front));
        Assert.Equal(front.Intensity, back.Intensity);
    }

    [Theory]
    [InlineData(0.25, 0.25)]
    [InlineData(0, 1)]
    public void TrySample_OnTheLamp_NoLightAndNoNaN(double s, double t)
    {
        Point3D on = new(-1 + (2 * s), 1, -0.5 + t);
        Assert.False(Above(1).TrySample(on, new SquarePoint(s, t), out LightSample sample));
        Assert.True(sample.Direction.IsFinite && sample.Intensity.IsFinite);
        Above(1).TrySample(on + new Vector3D(0, -1e-200, 0), new SquarePoint(s, t), out sample);
        Assert.True(sample.Direction.IsFinite && sample.Intensity.IsFinite);
    }

    [Fact]
    public void HalfPlaneBetweenLampAndFloor_PenumbraIsAsWideAsGeometrySays()
    {
        // A lamp of width 2 at height 3, an edge x = 0 at height 1: the penumbra is |x| < (2 / 2) (1 / (3 - 1)) = 1/2.
        Scene scene = Floor(new OrthographicCamera(new Point3D(0, 0.5, 0), Point3D.Origin, 2, Vector3D.UnitZ));
        scene.Lights.Add(Above(3, samples: 64));
        RenderOptions options = new() { Width = 64, Height = 64, Threads = 1 };
        Picture lit = Renderer.Render(scene, options).Picture;
        scene.Add(new Quad(new Point3D(-50, 1, -50), 50 * Vector3D.UnitX, 100 * Vector3D.UnitZ), new Material());
        Picture shaded = Renderer.Render(scene, options).Picture;
        for (int row = 0; row < 64; row++)
        {
            for (int column = 0; column < 64; column++)
            {
                // Seen from above with +z up, +x is on the left.
                double x = 1 - ((column + 0.5) / 32);
                float share = shaded[column, row].G / lit[column, row].G;
                Assert.InRange(share, x > 0.5 ? 1 : 0, x < -0.5 ? 0 : 1);
                if (Math.Abs(x) < 0.45)
                {
                    // The share of the lamp's width that is seen; its light varies by less than a quarter over the lamp.
                    Assert.InRange(share, 0.5 + x - 0.11, 0.5 + x + 0.11);
                }
            }
        }
    }

    [Fact]
    public void Noise_FallsAtLeastWithTheRootOfTheSamples()
    {
        double coarse = Error(4, 1), middle = Error(16, 1), fine = Error(64, 1), overPixels = Error(4, 16);
        Assert.InRange(middle, 0, coarse / 2);
        Assert.InRange(fine, 0, middle / 2);

        // Samples of a pixel are one sequence: 16 x 4 are as good as 64, up to the luck of the draw.
        Assert.InRange(overPixels, 0, 1.5 * fine);
    }

    [Fact]
    public void Visible_ShowsItsRadianceToCameraAndMirror()
    {
        var scene = new Scene { Camera = new OrthographicCamera(Point3D.Origin, new Point3D(0, 1, 0), 0.1, Vector3D.UnitZ), Background = Intensity.Grey(0.125f) };
        QuadLight light = new(new Point3D(-1, 2, -1), 2 * Vector3D.UnitZ, 2 * Vector3D.UnitX, new Intensity(3, 4, 5)) { IsVisible = true };
        scene.Lights.Add(light);
        Assert.Equal(light.Radiance, TestScenes.Render(scene, 1, 1)[0, 0]);
        scene.Camera = new OrthographicCamera(new Point3D(0, 4, 0), Point3D.Origin, 0.1, Vector3D.UnitZ);
        Assert.Equal(Intensity.Black, TestScenes.Render(scene, 1, 1)[0, 0]);
        scene.Camera = new OrthographicCamera(new Point3D(0, 1, 0), Point3D.Origin, 0.1, Vector3D.UnitZ);
        scene.Add(new InfinitePlane(), new Material { Diffuse = Intensity.Black, Reflection = Intensity.Grey(0.5f) });
        Assert.Equal(light.Radiance * 0.5f, TestScenes.Render(scene, 1, 1)[0, 0]);
        scene.Lights[0] = new QuadLight(new Point3D(-1, 2, -1), 2 * Vector3D.UnitZ, 2 * Vector3D.UnitX, new Intensity(3, 4, 5));
        Assert.Equal(Intensity.Grey(0.0625f), TestScenes.Render(scene, 1, 1)[0, 0]);
    }

    [Fact]
    public void Visible_DoesNotShadeItsOwnLight()
    {
        Intensity hidden = Seen(0.1, 0.2, Above(1));
        QuadLight light = new(new Point3D(-1, 1, -0.5), Vector3D.UnitZ, 2 * Vector3D.UnitX, new Intensity(1, 2, 0.5f)) { IsVisible = true };
        Assert.Equal(hidden, Seen(0.1, 0.2, light));
    }

    [Fact]
    public void Constructor_BadArguments_SaysWhatIsAllowed()
    {
        Assert.Throws<ArgumentException>(() => new QuadLight(Point3D.Origin, Vector3D.UnitX, 2 * Vector3D.UnitX, Intensity.White));
        Assert.Throws<ArgumentOutOfRangeException>(() => new QuadLight(Point3D.Origin, Vector3D.UnitX, Vector3D.UnitY, Intensity.Grey(-1)));
        ArgumentOutOfRangeException failure = Assert.Throws<ArgumentOutOfRangeException>(() => Above(1, samples: 0));
        Assert.Contains("[1, 4096]", failure.Message, StringComparison.Ordinal);
        Assert.Throws<ArgumentOutOfRangeException>(() => Above(1, samples: 4097));
        Assert.Throws<ArgumentOutOfRangeException>(() => Above(1, sides: (LightSides)7));
    }

    [Fact]
    public void Sample_AnyWidth_SameBitsAsOnePoint() => new WideTest().RunAllDoubles();

    private static Scene Floor(Camera camera)
    {
        var scene = new Scene { Camera = camera };
        scene.Add(new InfinitePlane(), new Material { Diffuse = Intensity.Grey(0.5f) });
        return scene;
    }

    /// <summary>What a camera below the lamp sees of the floor at (x, z).</summary>
    private static Intensity Seen(double x, double z, QuadLight light)
    {
        Scene scene = Floor(new OrthographicCamera(new Point3D(x, 0.25, z), new Point3D(x, 0, z), 1e-6, Vector3D.UnitX));
        scene.Lights.Add(light);
        return TestScenes.Render(scene, 1, 1)[0, 0];
    }

    /// <summary>Root mean square of the error of a penumbra against 4096 samples.</summary>
    private static double Error(int samples, int pixelSamples)
    {
        // All samples of a pixel at nearly the same place, so that only the lamp's samples matter.
        Picture Render(int lamp, int pixel)
        {
            Scene scene = Floor(new OrthographicCamera(new Point3D(0, 0.5, 0), Point3D.Origin, 1e-3, Vector3D.UnitZ));
            scene.Lights.Add(Above(3, lamp));
            scene.Add(new Sphere(new Point3D(0.8, 1.7, 0.3), 0.5), new Material());
            return Renderer.Render(scene, new RenderOptions { Width = 32, Height = 32, Threads = 1, Samples = pixel }).Picture;
        }

        Picture rough = Render(samples, pixelSamples);
        Picture exact = Render(4096, 1);
        double mean = exact.Pixels.ToArray().Average(pixel => pixel.R);
        return Math.Sqrt(rough.Pixels.ToArray().Average(pixel => (pixel.R - mean) * (pixel.R - mean)));
    }

    private sealed unsafe class WideTest : ILaneTest
    {
        public void Run<R, F, I>()
            where R : unmanaged, ILane<R, F, I>
            where F : unmanaged, ILane<F, F, I>
            where I : unmanaged, IIndexLane<I>
        {
            using LaneMemory memory = new();
            SurfaceBatch<R, F, I> surfaces = new(memory, 64);
            SquareColumns<R> places = new(memory, 64);
            LightColumns<R, F> samples = new(memory, 64);
            ShapeCases cases = new(9);
            Point3D[] points = [.. Enumerable.Range(0, 64).Select(_ => cases.Center(3))];
            for (int i = 0; i < 64; i++)
            {
                R.Put(surfaces.PointX, i, points[i].X);
                R.Put(surfaces.PointY, i, points[i].Y);
                R.Put(surfaces.PointZ, i, points[i].Z);
                R.Put(places.S, i, i / 64.0);
                R.Put(places.T, i, i * 37 % 64 / 64.0);
            }

            // 16 samples: each stands for 1/16 of the lamp, a power of two, so that the bits agree.
            foreach (LightSides sides in Enum.GetValues<LightSides>())
            {
                QuadLight light = Above(0.5, 16, sides);
                ((IWideAreaLight)light).Sample(surfaces, places, samples, 64 / R.Width);
                for (int i = 0; i < 64; i++)
                {
                    light.TrySample(points[i], new SquarePoint(i / 64.0, i * 37 % 64 / 64.0), out LightSample expected);
                    LightSample found = new(
                        new Vector3D(R.Take(samples.DirectionX, i), R.Take(samples.DirectionY, i), R.Take(samples.DirectionZ, i)),
                        R.Take(samples.Distance, i),
                        samples.Intensity.Take(i) * 16);
                    Assert.Equal(expected, found);
                }
            }
        }
    }
}
