namespace LabRaytracer.Tests.Rendering;

/// <summary>Lamps of several samples: the same picture on any number of threads and lanes and for any part, and other noise for another seed.</summary>
public sealed class ManySamplesTests
{
    private const int Width = 41, Height = 37;

    [Theory]
    [InlineData(Precision.Double)]
    [InlineData(Precision.Single)]
    public void Render_AnyThreadsAndWidths_SameBits(Precision precision)
    {
        Scene scene = Sampled();
        Picture Render(int laneWidth, int threads) => Renderer.Render(
            scene, new RenderOptions { Width = Width, Height = Height, Threads = threads, Precision = precision, Samples = 4 }, laneWidth, null, default).Picture;
        Picture narrow = Render(1, 1);
        foreach (int laneWidth in new[] { 4, 8, 16 })
        {
            PictureAssert.SameBits(narrow, Render(laneWidth, laneWidth / 4));
        }
    }

    [Fact]
    public void Render_Crop_IsPartOfTheWholePicture()
    {
        Scene scene = Sampled();
        Picture Render(PixelRectangle? crop) => Renderer.Render(scene, new RenderOptions { Width = Width, Height = Height, Threads = 2, Crop = crop }).Picture;
        Picture whole = Render(null), part = Render(new PixelRectangle(11, 5, 30, 20));
        for (int y = 0; y < 20; y++)
        {
            Assert.True(part.Row(y).SequenceEqual(whole.Row(5 + y).Slice(11, 30)), $"Row {y} differs.");
        }
    }

    [Fact]
    public void Render_AnotherSeed_OtherNoise()
    {
        Picture Render(int seed) => Renderer.Render(Sampled(), new RenderOptions { Width = Width, Height = Height, Threads = 1, Seed = seed }).Picture;
        PictureAssert.SameBits(Render(3), Render(3));
        Assert.False(Render(3).Pixels.SequenceEqual(Render(4).Pixels));
    }

    [Fact]
    public void Render_LampOfOnesOwn_IsAskedForEachSample()
    {
        // Two sheets of light: from the left and from the right, half each.
        var scene = new Scene { Camera = TestScenes.AboveQuad() };
        scene.Add(new Quad(), new Material());
        scene.Lights.Add(new Sides());
        Assert.All(TestScenes.Render(scene, 8, 8).Pixels.ToArray(), pixel => Assert.Equal((0.3, 0, 0.3), (Math.Round(pixel.R, 6), pixel.G, Math.Round(pixel.B, 6))));
        RenderStatistics statistics = Renderer.Render(scene, new RenderOptions { Width = 8, Height = 8 }).Statistics;
        Assert.Equal((64 * 4, 64 * 4), (statistics.ShadowRays, statistics.LampSamples));
    }

    private static Scene Sampled()
    {
        Scene scene = TestScenes.Everything();
        scene.Lights.Clear();
        scene.Lights.Add(new QuadLight(new Point3D(-1, 3, -1), 2 * Vector3D.UnitZ, 2 * Vector3D.UnitX, new Intensity(4, 3, 2)) { Samples = 4, IsVisible = true });
        scene.Lights.Add(new EnvironmentLight(TestScenes.Random(16, 8, 7)) { Samples = 4, Rotation = Transform.Rotation(new Vector3D(1, 1, 0), 30) });
        scene.Lights.Add(new Sides());
        scene.BackgroundRotation = Transform.Rotation(new Vector3D(1, 1, 0), 30);
        return scene;
    }

    private sealed class Sides : Light
    {
        public override int SampleCount => 4;

        public override bool TrySample(Point3D point, out LightSample sample) => throw new NotSupportedException();

        public override bool TrySample(Point3D point, SquarePoint place, out LightSample sample)
        {
            bool isLeft = place.S < 0.5;
            sample = new LightSample(new Vector3D(isLeft ? -0.8 : 0.8, 0.6, 0), double.PositiveInfinity, isLeft ? new Intensity(1, 0, 0) : new Intensity(0, 0, 1));
            return true;
        }
    }
}
