using RenderScene;

namespace LabRaytracer.Tests.Samples;

public sealed class SampleSceneTests
{
    public static TheoryData<string> Names => [.. Directory.GetFiles(SampleScenes.Find(), "??-*.json").Select(path => Path.GetFileName(path)!).Order(StringComparer.Ordinal)];

    [Theory]
    [MemberData(nameof(Names))]
    public void Scene_Small_RendersWithoutAPixelThatIsNotFinite(string name)
    {
        LoadedScene scene = SceneFile.Load(SampleScenes.File(name));
        RenderResult result = Renderer.Render(scene.Scene, new RenderOptions { Width = 64, Height = 36, MaxDepth = scene.RenderOptions.MaxDepth });
        Assert.Equal(0, result.Statistics.NotFinitePixels);
        HashSet<Intensity> colors = [.. result.Picture.Pixels];
        Assert.True(colors.Count > 4, $"{name} shows {colors.Count} colours only");
        Assert.NotEqual("", SceneDescription.Read(SampleScenes.File(name)));
    }

    /// <summary>One worker renders six tiles one after the other: the last one must not show what the ones before left in its columns.</summary>
    [Theory]
    [MemberData(nameof(Names))]
    public void Scene_LastTile_HasTheBitsOfATileAlone(string name)
    {
        LoadedScene scene = SceneFile.Load(SampleScenes.File(name));
        Picture Show(PixelRectangle? crop) =>
            Renderer.Render(scene.Scene, new RenderOptions { Width = 96, Height = 64, MaxDepth = scene.RenderOptions.MaxDepth, Threads = 1, Crop = crop }).Picture;
        Picture whole = Show(null), part = Show(new PixelRectangle(70, 37, 25, 20));
        for (int row = 0; row < part.Height; row++)
        {
            Assert.Equal(whole.Row(37 + row).Slice(70, part.Width).ToArray(), part.Row(row).ToArray());
        }
    }

    [Fact]
    public void Names_OfTheScenes_HaveDifferentNumbers()
    {
        string[] numbers = [.. Directory.GetFiles(SampleScenes.Find(), "??-*.json").Select(path => Path.GetFileName(path)[..2])];
        Assert.Equal(numbers.Length, numbers.Distinct().Count());
    }

    [Fact]
    public void Earth_MiddleOfThePicture_IsTenDegreesEastAndUpright()
    {
        LoadedScene scene = SceneFile.Load(SampleScenes.File("06-earth.json"));
        Picture uv = Renderer.Render(scene.Scene, new RenderOptions { Width = 321, Height = 181, View = RenderView.Uv }).Picture;
        Intensity middle = uv[160, 90], right = uv[180, 90], above = uv[160, 70];

        // Longitude 10 degrees east is u = 190 / 360; the camera stands at height 1.7 and distance 4.2: atan(1.7 / 4.2) = 22.04 degrees north.
        Assert.InRange(middle.R, (190 / 360f) - 1e-4f, (190 / 360f) + 1e-4f);
        Assert.InRange(middle.G, ((90 + 22.04f) / 180) - 1e-3f, ((90 + 22.04f) / 180) + 1e-3f);
        Assert.True(right.R > middle.R, "east must be to the right");
        Assert.True(above.G > middle.G, "north must be up");
    }

    [Fact]
    public void Earth_Map_HasGreenlandWhiteAndTheAtlanticBlue()
    {
        Texture earth = Texture.Load(SampleScenes.File("textures/earth-2048x1024.png"));
        Intensity greenland = At(earth, -40, 72), atlantic = At(earth, -37, 22), antarctica = At(earth, 100, -80);
        Assert.True(greenland.R > 0.7f && antarctica.R > 0.7f, $"{greenland} {antarctica}");
        Assert.True(atlantic.B > 4 * atlantic.R, $"{atlantic}");
    }

    [Fact]
    public void LabScene_Seam_HasGreenToTheLeftAndRedToTheRight()
    {
        // Sheet, figure 8: the outer columns meet on the half-meridian x = 0, z > 0. One cell is 15 degrees; look 14 degrees to each side, just off the lines.
        GridTexture grid = new();
        SphericalMapping mapping = new();
        Intensity left = Seen(-14), right = Seen(14);
        Assert.True(left.G > 3 * left.R, $"{left}");
        Assert.True(right.R > 3 * right.G, $"{right}");

        Intensity Seen(double degrees)
        {
            Point3D point = new(Math.Sin(degrees * Math.PI / 180), 0.02, Math.Cos(degrees * Math.PI / 180));
            return grid.Sample(new TextureLookup(mapping.Map(new SurfacePosition(point, default, default))));
        }
    }

    private static Intensity At(Texture map, double longitude, double latitude) =>
        map.Sample(TextureLookup.At((longitude + 180) / 360, (latitude + 90) / 180));
}
