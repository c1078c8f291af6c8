using LabRaytracer.Tests.Rendering;

namespace LabRaytracer.Tests.Lighting;

/// <summary>Light from all around against closed forms.</summary>
public sealed class EnvironmentLightTests
{
    [Theory]
    [InlineData(64)]
    [InlineData(4096)]
    public void EvenSky_OverALevelPlane_IsDiffuseTimesRadianceWithinTwoOverSamples(int samples)
    {
        // One texel: even light that is sampled. Each of the equal bands of height has one sample, all at the same place of their bands: the error of
        // the integral of 4 cos over a half of the sphere is at most half of its variation, 4, over the number of bands.
        Picture picture = Plane(new EnvironmentLight(Sky(new Intensity(1, 2, 0.5f))) { Samples = samples }, Vector3D.UnitY, 4);
        Assert.All(picture.Pixels.ToArray(), pixel => Assert.Equal(0.5, pixel.R, 0.5 * 2.0 / samples));
        Assert.All(picture.Pixels.ToArray(), pixel => Assert.Equal(2 * pixel.R, pixel.G, 1e-5f));
    }

    public static TheoryData<ITexture> Filtered => new(
        new CheckerTexture { Even = Intensity.White, Odd = Intensity.White, Filter = PatternFilter.Area },
        new CheckerTexture { Even = Intensity.White, Odd = Intensity.White, Filter = PatternFilter.Area, Space = CheckerSpace.Local },
        new TransformedTexture(new NoiseTexture { Ramp = ColorRamp.Between(Intensity.White, Intensity.White) }) { Frame = TextureFrame.World },
        new TriplanarTexture(new CheckerTexture { Even = Intensity.White, Odd = Intensity.White, Filter = PatternFilter.Area }),
        new OneOfMyOwn(TextureNeeds.Coordinate | TextureNeeds.LocalPoint | TextureNeeds.WorldPoint | TextureNeeds.Footprint),
        new Texture(new[,] { { Intensity.White, Intensity.White }, { Intensity.White, Intensity.White } }).With(new SamplingOptions { Filter = TextureFilter.Ewa }),
        new Texture(new[,] { { Intensity.White, Intensity.White }, { Intensity.White, Intensity.White } }).With(new SamplingOptions { Filter = TextureFilter.Area }));

    /// <summary>Samples of the sky are points: textures that read footprints get none, white ones are the even sky.</summary>
    [Theory, MemberData(nameof(Filtered), DisableDiscoveryEnumeration = true)]
    public void SkyThatReadsFootprints_Sampled_IsLookedUpAtPoints(ITexture white) =>
        AssertMean(0.5, Plane(new EnvironmentLight(TextureSlot.Of(white)) { Samples = 16 }, Vector3D.UnitY, 64));

    [Theory]
    [InlineData(0, 1, 0)]
    [InlineData(1, 1, 1)]
    [InlineData(-0.3, -0.2, 0.9)]
    public void EvenSky_FewSamples_AreRightInTheMean(double x, double y, double z) =>
        AssertMean(0.5, Plane(new EnvironmentLight(Sky(Intensity.White)) { Samples = 16 }, new Vector3D(x, y, z), 64));

    [Theory]
    [InlineData(TextureFilter.Nearest, 16, 8)]
    [InlineData(TextureFilter.Nearest, 96, 48)]
    [InlineData(TextureFilter.Bilinear, 5, 3)]
    [InlineData(TextureFilter.Bilinear, 96, 48)]
    public void RandomSky_MeanOfThePixels_IsTheIntegral(TextureFilter filter, int width, int height)
    {
        // k_d / pi times the integral of L cos sin over theta up to pi / 2 and phi, by the midpoint rule.
        Texture texture = TestScenes.Random(width, height, 5).With(new SamplingOptions { Filter = filter });
        const int Rings = 240, Sectors = 480;
        double integral = 0;
        for (int i = 0; i < Rings * Sectors; i++)
        {
            double theta = Math.PI / 2 * ((i / Sectors) + 0.5) / Rings, u = ((i % Sectors) + 0.5) / Sectors;
            var at = new TextureLookup(new TextureCoordinate(u, 1 - (theta / Math.PI)), WrapV: TextureWrap.Clamp);
            integral += texture.Sample(at).R * Math.Cos(theta) * Math.Sin(theta) * (Math.PI / 2 / Rings) * (2 * Math.PI / Sectors);
        }

        AssertMean(0.5 / Math.PI * integral, Plane(new EnvironmentLight(texture) { Samples = 64 }, Vector3D.UnitY, 64));
    }

    [Theory]
    [InlineData(100, 200)]
    [InlineData(400, 140)]
    [InlineData(0, 255)]
    public void OneBrightTexel_IsADirectionalLightOfTheSameIrradiance(int column, int up)
    {
        Texture texture = new Texture(512, 256).With(new SamplingOptions { Filter = TextureFilter.Nearest });
        texture.ColorMap[column, up] = new Intensity(5000, 4000, 3000);
        // The integral of the direction over the texel: its length is the irradiance of a plane that faces the texel, for radiance 1.
        double theta1 = Math.PI * (255 - up) / 256, theta2 = Math.PI * (256 - up) / 256, phi1 = 2 * Math.PI * column / 512, phi2 = phi1 + (2 * Math.PI / 512);
        double across = ((theta2 - theta1) / 2) - ((Math.Sin(2 * theta2) - Math.Sin(2 * theta1)) / 4);
        Vector3D flux = new(
            across * (Math.Cos(phi1) - Math.Cos(phi2)),
            (phi2 - phi1) * (Math.Pow(Math.Sin(theta2), 2) - Math.Pow(Math.Sin(theta1), 2)) / 2,
            across * (Math.Sin(phi2) - Math.Sin(phi1)));
        Vector3D normal = (flux.Normalized() + new Vector3D(0.1, 0.3, -0.2)).Normalized();
        Picture around = Plane(new EnvironmentLight(texture) { Samples = 64 }, normal, 8);
        Picture sun = Plane(new DirectionalLight(-flux, texture.ColorMap[column, up] * (float)(flux.Length / Math.PI)), normal, 8);
        for (int i = 0; i < 64; i++)
        {
            // The cosine varies by less than half a percent over a texel of 0.7 degrees, the mean of 64 even samples by much less.
            Assert.Equal(1, around.Pixels[i].R / sun.Pixels[i].R, 2e-4f);
            Assert.Equal(1, around.Pixels[i].B / sun.Pixels[i].B, 2e-4f);
        }
    }

    [Fact]
    public void EvenSky_BesideAWall_IsHalf()
    {
        var scene = new Scene { Camera = new OrthographicCamera(new Point3D(1, 1, 0), new Point3D(1, 0, 0), 1e-3, Vector3D.UnitZ) };
        scene.Add(new InfinitePlane(), new Material());
        scene.Add(new InfinitePlane(Point3D.Origin, Vector3D.UnitX), new Material { Diffuse = Intensity.Black });
        scene.Lights.Add(new EnvironmentLight(Sky(Intensity.White)) { Samples = 4096 });
        Assert.Equal(0.5, TestScenes.Render(scene, 1, 1)[0, 0].R, 1e-3);
    }

    [Fact]
    public void Noise_FallsAtLeastWithTheRootOfTheSamples()
    {
        double coarse = Error(16), middle = Error(64), fine = Error(256);
        Assert.InRange(middle, 0, coarse / 2);
        Assert.InRange(fine, 0, middle / 2);
    }

    [Theory]
    [InlineData(1, 1)]
    [InlineData(2, 1)]
    [InlineData(30, 20)]
    [InlineData(333, 77)]
    [InlineData(1500, 700)]
    public void EvenSky_AnyResolution_SameEnergy(int width, int height)
    {
        Texture texture = new(width, height);
        for (int i = 0; i < width * height; i++)
        {
            texture.ColorMap[i % width, i / width] = Intensity.White;
        }

        Picture one = Plane(new EnvironmentLight(Sky(Intensity.White)) { Samples = 64 }, Vector3D.UnitY, 2);
        Picture many = Plane(new EnvironmentLight(texture) { Samples = 64 }, Vector3D.UnitY, 2);
        for (int i = 0; i < 4; i++)
        {
            Assert.Equal(one.Pixels[i].R, many.Pixels[i].R, 1e-6f);
        }
    }

    [Fact]
    public void ConstantColour_IsAddedInClosedFormWithoutSamples()
    {
        foreach (TextureSlot constant in new TextureSlot[] { new Intensity(1, 2, 0.5f), TextureSlot.Of(new ConstantTexture(new Intensity(1, 2, 0.5f))) })
        {
            Scene scene = TestScenes.QuadFromAbove(new Material { Diffuse = Intensity.Grey(0.5f) });
            scene.Lights.Add(new EnvironmentLight(constant));
            scene.Add(new Sphere(new Point3D(0, 1, 0), 0.5), new Material { Diffuse = Intensity.Grey(0.5f) });
            RenderResult result = Renderer.Render(scene, new RenderOptions { Width = 20, Height = 20, Threads = 1 });
            Assert.All(result.Picture.Pixels.ToArray(), pixel => Assert.Equal(new Intensity(0.5f, 1, 0.25f), pixel));
            Assert.Equal((0, 0, 0, 0), (result.Statistics.ShadowRays, result.Statistics.ShadowRaysSkipped, result.Statistics.Mappings, result.Statistics.TextureLookups));
        }
    }

    [Fact]
    public void BlackSky_NothingIsDrawn()
    {
        Scene scene = TestScenes.QuadFromAbove(new Material());
        scene.Lights.Add(new EnvironmentLight(new Texture(8, 4)));
        RenderStatistics statistics = Renderer.Render(scene, new RenderOptions { Width = 20, Height = 20, Threads = 1 }).Statistics;
        Assert.Equal((0, 0, 0), (statistics.ShadowRays, statistics.ShadowRaysSkipped, statistics.TextureLookups));
    }

    [Fact]
    public void Rotation_TurnsTheLight()
    {
        // Light from +X (u = 1/4), turned by 90 degrees about +Y: from -Z.
        Texture texture = new Texture(64, 32).With(new SamplingOptions { Filter = TextureFilter.Nearest });
        texture.ColorMap[16, 16] = Intensity.Grey(1000);
        float Brightness(Vector3D normal) =>
            Plane(new EnvironmentLight(texture) { Rotation = Transform.Rotation(Vector3D.UnitY, 90), Samples = 16 }, normal, 1)[0, 0].R;
        Assert.True(Brightness(-Vector3D.UnitZ) > 0.1f);
        Assert.InRange(Brightness(Vector3D.UnitX) / Brightness(-Vector3D.UnitZ), 0, 0.1f);
        Assert.Equal(0, Brightness(Vector3D.UnitZ));
    }

    [Theory]
    [InlineData(false)]
    [InlineData(true)]
    public void ProceduralAndTransformedSkies_AreRightInTheMean(bool isProcedural)
    {
        // White where v >= 1/2: the upper half. A plane that faces up sees nothing else; one that faces down nothing at all.
        TextureSlot sky = isProcedural
            ? TextureSlot.Of(new Halves())
            : new TextureSlot
            {
                Texture = new Texture(new[,] { { Intensity.White, Intensity.Black } }).With(new SamplingOptions { Filter = TextureFilter.Nearest }),
                Transform = new UvTransform(new TextureCoordinate(0, 1), 0, new TextureCoordinate(1, -1), new TextureCoordinate(0, 0)),
            };
        Assert.Equal(0.5f, Plane(new EnvironmentLight(sky) { Samples = 1024 }, Vector3D.UnitY, 1)[0, 0].R, 2e-3f);
        Assert.Equal(0, Plane(new EnvironmentLight(sky) { Samples = 1024 }, -Vector3D.UnitY, 1)[0, 0].R);
    }

    [Fact]
    public void Properties_BadValues_SayWhatIsAllowed()
    {
        Assert.Throws<ArgumentException>(() => new EnvironmentLight(Intensity.White) { Rotation = Transform.Translation(Vector3D.UnitX) });
        Assert.Throws<ArgumentException>(() => new EnvironmentLight(Intensity.White) { Rotation = Transform.Scaling(new Vector3D(1, 1, -1)) });
        Assert.Throws<ArgumentOutOfRangeException>(() => new EnvironmentLight(Intensity.White) { Samples = 0 });
        Assert.Throws<ArgumentNullException>(() => new EnvironmentLight(null!));
        Assert.False(new EnvironmentLight(Intensity.White).TrySample(Point3D.Origin, out _));
    }

    /// <summary>The mean of the red of independent pixels lies within four times its standard deviation.</summary>
    private static void AssertMean(double expected, Picture picture)
    {
        double[] values = [.. picture.Pixels.ToArray().Select(pixel => (double)pixel.R)];
        double mean = values.Average(), deviation = Math.Sqrt(values.Average(value => (value - mean) * (value - mean)) / values.Length);
        Assert.InRange(mean, expected - (4 * deviation), expected + (4 * deviation));
        Assert.InRange(deviation / expected, 0, 0.003);
    }

    /// <summary>Even light that is drawn in samples.</summary>
    private static Texture Sky(Intensity color) => new(new[,] { { color } });

    /// <summary>A matte plane of k_d 1/2 through the origin, seen from its side of the normal.</summary>
    private static Picture Plane(Light light, Vector3D normal, int side)
    {
        Vector3D n = normal.Normalized();
        var scene = new Scene { Camera = new OrthographicCamera(Point3D.Origin + n, Point3D.Origin, 1, new Vector3D(n.Z, n.X, -n.Y)) };
        scene.Add(new InfinitePlane(Point3D.Origin, n), new Material { Diffuse = Intensity.Grey(0.5f) });
        scene.Lights.Add(light);
        return TestScenes.Render(scene, side, side);
    }

    /// <summary>Root mean square of the pixels' error under a random sky.</summary>
    private static double Error(int samples)
    {
        Texture sky = TestScenes.Random(32, 16, 3);
        double exact = Plane(new EnvironmentLight(sky) { Samples = 4096 }, new Vector3D(1, 2, 3), 2).Pixels.ToArray().Average(pixel => (double)pixel.R);
        Picture rough = Plane(new EnvironmentLight(sky) { Samples = samples }, new Vector3D(1, 2, 3), 24);
        return Math.Sqrt(rough.Pixels.ToArray().Average(pixel => (pixel.R - exact) * (pixel.R - exact)));
    }

    private sealed class Halves : ITexture
    {
        public Intensity Sample(in TextureLookup lookup) => Intensity.Grey(lookup.Coordinate.V >= 0.5 ? 1 : 0);
    }

    private sealed class OneOfMyOwn(TextureNeeds needs) : ITexture
    {
        public TextureNeeds Needs => needs;

        public Intensity Sample(in TextureLookup lookup) =>
            lookup.Footprint.IsPoint && lookup.LocalFootprint.IsPoint && lookup.WorldFootprint.IsPoint ? Intensity.White : Intensity.Black;
    }
}
