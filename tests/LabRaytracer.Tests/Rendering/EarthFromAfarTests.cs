namespace LabRaytracer.Tests.Rendering;

/// <summary>A globe seen from afar, several texels in each pixel: filters against the exact means over the footprints, and against many samples.</summary>
public sealed class EarthFromAfarTests
{
    private const int Side = 80;

    private static readonly Texture s_earth = Earth();

    private static readonly bool[] s_inside = Inside();

    private static readonly Lazy<Picture> s_means = new(() => Render(TextureFilter.Area, 1));

    // Bounds set before anything was measured: a pixel of 8-bit noise, seen from afar, keeps little contrast, of which the right weights lose a hundredth; a pole or a limb gone wrong costs more.
    [Theory]
    [InlineData(TextureFilter.Bilinear, 0.06, 1)]
    [InlineData(TextureFilter.Trilinear, 0.01, 0.06)]
    [InlineData(TextureFilter.Ewa, 0, 0.01)]
    public void Render_OneSample_ErrorAgainstTheExactMeans(TextureFilter filter, double least, double most) =>
        Assert.InRange(Error(Render(filter, 1), s_means.Value), least, most);

    [Fact]
    public void Render_EwaWithOneSample_IsNearerToTheConvergedPictureThanNearestWith64()
    {
        Picture converged = Render(TextureFilter.Nearest, 1024);
        Assert.InRange(Error(Render(TextureFilter.Ewa, 1), converged), 0, Error(Render(TextureFilter.Nearest, 64), converged));
    }

    private static Picture Render(TextureFilter filter, int samples) =>
        Renderer.Render(Globe(TextureSlot.Of(s_earth.With(SamplingOptions.Default.With(filter)))), new RenderOptions { Width = Side, Height = Side, Samples = samples }).Picture;

    private static Scene Globe(TextureSlot texture)
    {
        // The axis leans towards the eye, so that a pole is seen.
        Scene scene = new() { Camera = new PerspectiveCamera(new Point3D(0, 4, 8), Point3D.Origin, 13) };
        scene.Add(new Sphere(Point3D.Origin, 1), TestScenes.Shining(texture));
        return scene;
    }

    /// <summary>Pixels that the globe covers, and their neighbours too: textures alone make their error.</summary>
    private static bool[] Inside()
    {
        Picture objects = Renderer.Render(Globe(TextureSlot.Of(s_earth)), new RenderOptions { Width = Side, Height = Side, View = RenderView.Object }).Picture;
        bool IsGlobe(int x, int y) => x >= 0 && y >= 0 && x < Side && y < Side && objects[x, y] != Intensity.Black;
        return [.. Enumerable.Range(0, Side * Side).Select(i => Enumerable.Range(0, 9).All(k => IsGlobe((i % Side) - 1 + (k % 3), (i / Side) - 1 + (k / 3))))];
    }

    private static double Error(Picture a, Picture b)
    {
        double sum = 0;
        int count = 0;
        for (int i = 0; i < s_inside.Length; i++)
        {
            if (s_inside[i])
            {
                double difference = a.Pixels[i].G - b.Pixels[i].G;
                sum += difference * difference;
                count++;
            }
        }

        Assert.InRange(count, 2000, Side * Side);
        return Math.Sqrt(sum / count);
    }

    /// <summary>Continents of a few texels: noise of two sizes.</summary>
    private static Texture Earth()
    {
        Texture fine = TestScenes.Random(1024, 512), coarse = TestScenes.Random(256, 128);
        Intensity[,] colors = new Intensity[1024, 512];
        for (int i = 0; i < 1024 * 512; i++)
        {
            (int x, int y) = (i % 1024, i / 1024);
            colors[x, y] = Intensity.Lerp(fine.ColorMap[x, y], coarse.ColorMap[x / 4, y / 4], 0.7f);
        }

        return new Texture(colors);
    }
}
