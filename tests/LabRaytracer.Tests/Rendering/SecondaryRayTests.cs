namespace LabRaytracer.Tests.Rendering;

/// <summary>Mirrors and glass against closed forms.</summary>
public sealed class SecondaryRayTests
{
    /// <summary>White where a ray goes down, black where it goes up.</summary>
    private static readonly TextureSlot s_whiteBelow = TextureSlot.Of(new CheckerTexture { Columns = 1, Rows = 2 });

    [Fact]
    public void Mirror_ShowsTheBackgroundTimesItsColour()
    {
        var scene = new Scene { Background = new Intensity(1, 0.5f, 0.25f) };
        scene.Add(new InfinitePlane(Point3D.Origin, Vector3D.UnitZ), new Material { Diffuse = Intensity.Black, Reflection = new Intensity(0.25f, 0.5f, 0.75f) });
        Assert.All(TestScenes.Render(scene, 20, 20).Pixels.ToArray(), pixel => Assert.Equal(new Intensity(0.25f, 0.25f, 0.1875f), pixel));
        Picture direct = Renderer.Render(scene, new RenderOptions { Width = 20, Height = 20, MaxDepth = 0 }).Picture;
        Assert.All(direct.Pixels.ToArray(), pixel => Assert.Equal(Intensity.Black, pixel));
    }

    [Theory]
    [InlineData(0)]
    [InlineData(1)]
    [InlineData(5)]
    [InlineData(12)]
    public void TwoMirrorsThatShine_AddUpToAGeometricSeries(int depth)
    {
        // 1 + 1/2 + ... + 1/2^depth = 2 - 2^-depth, exact in float.
        Assert.Equal(2 - (float)Math.ScaleB(1, -depth), BetweenMirrors(depth, out _)[3, 4].R);
    }

    [Fact]
    public void TwoMirrorsThatShine_BelowTheLeastWeight_StopAndAreCounted()
    {
        Picture picture = BetweenMirrors(64, out RenderStatistics statistics);
        Assert.All(picture.Pixels.ToArray(), pixel => Assert.Equal(2 - (1f / 4096), pixel.R));
        Assert.Equal(12 * 64, statistics.SecondaryRays);
        Assert.Equal(64, statistics.SecondaryRaysSkipped);
    }

    [Theory]
    [InlineData(60, 1)]
    [InlineData(45, 1)]
    [InlineData(41, 0)]
    [InlineData(20, 0)]
    [InlineData(0.5, 0)]
    public void GlassFromInside_BeyondTheCriticalAngle_ReflectsAll(double degrees, float expected)
    {
        // arcsin(1 / 1.5) = 41.81 degrees. The ray goes up; reflected it sees the white below, refracted the black above.
        (double sin, double cos) = Math.SinCos(degrees * Math.PI / 180);
        var scene = new Scene
        {
            Camera = new OrthographicCamera(new Point3D(-sin, -cos, 0), Point3D.Origin, 0.1, Vector3D.UnitZ),
            Background = s_whiteBelow,
        };
        scene.Add(new InfinitePlane(), new Material { Diffuse = Intensity.Black, Transparency = Intensity.White, IndexOfRefraction = 1.5 });
        Assert.All(TestScenes.Render(scene, 5, 5).Pixels.ToArray(), pixel => Assert.Equal(Intensity.Grey(expected), pixel));
    }

    [Theory]
    [InlineData(1.5)]
    [InlineData(0.8)]
    public void GlassPlate_KeepsDirections(double index)
    {
        Scene Looking()
        {
            return new Scene
            {
                Camera = new PerspectiveCamera(new Point3D(0, 3, 0), new Point3D(0.3, 0, -0.5), 20),
                Background = TextureSlot.Of(new CoordinateColors()),
            };
        }

        Scene plate = Looking();
        var glass = new Material { Diffuse = Intensity.Black, Transparency = Intensity.White, IndexOfRefraction = index };
        plate.Add(new InfinitePlane(), glass);
        plate.Add(new InfinitePlane(new Point3D(0, -1, 0), -Vector3D.UnitY), glass);
        PictureAssert.Near(TestScenes.Render(Looking(), 30, 20), TestScenes.Render(plate, 30, 20), 1.2e-7);
    }

    [Theory]
    [InlineData(10)]
    [InlineData(45)]
    [InlineData(56.309932474020215)]
    [InlineData(80)]
    public void Dielectric_TransmitsWhatFresnelsSineAndTangentLawsSay(double degrees)
    {
        double a = degrees * Math.PI / 180, b = Math.Asin(Math.Sin(a) / 1.5);
        double perpendicular = Math.Pow(Math.Sin(a - b) / Math.Sin(a + b), 2), parallel = Math.Pow(Math.Tan(a - b) / Math.Tan(a + b), 2);
        var scene = new Scene
        {
            Camera = new OrthographicCamera(new Point3D(-Math.Sin(a), Math.Cos(a), 0), Point3D.Origin, 0.1, Vector3D.UnitZ),
            Background = s_whiteBelow,
        };
        scene.Add(
            new InfinitePlane(),
            new Material { Diffuse = Intensity.Black, Transparency = Intensity.White, IndexOfRefraction = 1.5, Fresnel = FresnelModel.Dielectric });
        PictureAssert.Near(Intensity.Grey((float)(1 - ((parallel + perpendicular) / 2))), TestScenes.Render(scene, 1, 1)[0, 0], 2e-7, "the pixel");

        // Nothing is lost: what is not transmitted is reflected.
        scene.Background = Intensity.White;
        PictureAssert.Near(Intensity.White, TestScenes.Render(scene, 1, 1)[0, 0], 1.2e-7, "the pixel");
    }

    /// <summary>Two mirrors of reflectance 1/2 that give off light 1, seen from between them, 8 x 8 pixels.</summary>
    private static Picture BetweenMirrors(int depth, out RenderStatistics statistics)
    {
        var scene = new Scene { Camera = new OrthographicCamera(Point3D.Origin, new Point3D(0, 0, -1), 1) };
        var mirror = new Material { Diffuse = Intensity.Black, Emission = Intensity.White, Reflection = Intensity.Grey(0.5f) };
        scene.Add(new InfinitePlane(new Point3D(0, 0, -1), Vector3D.UnitZ), mirror);
        scene.Add(new InfinitePlane(new Point3D(0, 0, 1), -Vector3D.UnitZ), mirror);
        RenderResult result = Renderer.Render(scene, new RenderOptions { Width = 8, Height = 8, MaxDepth = depth });
        statistics = result.Statistics;
        return result.Picture;
    }

    /// <summary>Texture coordinates as a colour.</summary>
    private sealed class CoordinateColors : ITexture
    {
        public Intensity Sample(in TextureLookup lookup) => new((float)lookup.Coordinate.U, (float)lookup.Coordinate.V, 0);
    }
}
