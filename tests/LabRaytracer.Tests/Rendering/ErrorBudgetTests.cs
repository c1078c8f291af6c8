namespace LabRaytracer.Tests.Rendering;

/// <summary>Samples where the error asks for them.</summary>
public sealed class ErrorBudgetTests
{
    private const int Width = 55, Height = 40;

    private static readonly Dictionary<PixelFilter, Lazy<Picture>> s_converged = Enum.GetValues<PixelFilter>().ToDictionary(filter => filter, filter => new Lazy<Picture>(() =>
        Renderer.Render(Edges(), new RenderOptions { Width = Width, Height = Height, Samples = 1024, Pattern = SamplePattern.Sobol, Seed = 5, PixelFilter = filter }).Picture));

    [Fact]
    public void Render_FlatPicture_TakesTheFewestSamples()
    {
        RenderStatistics statistics = Renderer.Render(new Scene { Background = Intensity.Grey(0.7f) }, Options(1e-6)).Statistics;
        Assert.Equal(4 * Width * Height, statistics.PrimaryRays);
        Assert.InRange(statistics.EstimatedRmse!.Value, 0, 1e-7);
    }

    [Theory]
    [InlineData(0.03, PixelFilter.Box)]
    [InlineData(0.01, PixelFilter.Box)]
    [InlineData(0.01, PixelFilter.Tent)]
    [InlineData(0.01, PixelFilter.Mitchell)]
    [InlineData(0.003, PixelFilter.Box)]
    public void Render_Edges_MeetTheBudgetWithFewSamples(double budget, PixelFilter filter)
    {
        Picture converged = s_converged[filter].Value;
        RenderResult result = Renderer.Render(Edges(), new RenderOptions
        {
            Width = Width, Height = Height, ErrorBudget = budget, MaxSamples = 4096, PixelFilter = filter,
        });
        Assert.InRange(PictureAssert.Rmse(converged, result.Picture), budget / 8, budget);
        Assert.InRange(result.Statistics.EstimatedRmse!.Value, PictureAssert.Rmse(converged, result.Picture), budget);
    }

    [Fact]
    public void Render_EdgesAtEqualError_TakesAThirdOfTheSamplesOfAllAlike()
    {
        Picture converged = s_converged[PixelFilter.Box].Value;
        Picture alike = Renderer.Render(Edges(), new RenderOptions { Width = Width, Height = Height, Samples = 64, Pattern = SamplePattern.Sobol }).Picture;
        RenderResult result = Renderer.Render(Edges(), Options(0.003));
        Assert.True(PictureAssert.Rmse(converged, result.Picture) < PictureAssert.Rmse(converged, alike), $"{PictureAssert.Rmse(converged, result.Picture)} {PictureAssert.Rmse(converged, alike)}");
        Assert.True(result.Statistics.PrimaryRays < 64 * Width * Height / 3, $"{result.Statistics.PrimaryRays / (double)(Width * Height)}");
    }

    [Fact]
    public void Render_ImpossibleBudget_EndsAtTheMostSamplesAndSaysSo()
    {
        RenderStatistics statistics = Renderer.Render(Edges(), Options(1e-9, most: 16)).Statistics;
        Assert.InRange(statistics.PrimaryRays, 5 * Width * Height, 16 * Width * Height);
        Assert.True(statistics.EstimatedRmse > 1e-9);
    }

    [Fact]
    public void Render_Samples_AreTheFewest()
    {
        RenderOptions options = new() { Width = Width, Height = Height, Samples = 9, ErrorBudget = 1 };
        Assert.Equal(16 * Width * Height, Renderer.Render(new Scene(), options).Statistics.PrimaryRays);
    }

    [Fact]
    public void Render_AnyThreadsAndVectorWidth_SameBits()
    {
        Scene scene = TestScenes.Everything();
        scene.Lights.Add(new QuadLight(new Point3D(-1, 3, 2), new Vector3D(1, 0, 0), new Vector3D(0, 0, -1), Intensity.White) { Samples = 3 });
        Picture one = Renderer.Render(scene, Options(0.02, threads: 1), 1, null, default).Picture;
        PictureAssert.SameBits(one, Renderer.Render(scene, Options(0.02, threads: 2)).Picture);
        PictureAssert.SameBits(one, Renderer.Render(scene, Options(0.02, threads: 3), 4, null, default).Picture);
        PictureAssert.SameBits(one, Renderer.Render(scene, Options(0.02, threads: 1), 8, null, default).Picture);
    }

    [Fact]
    public void Render_SoftShadow_SamplesOfAPixelComplementOneAnother()
    {
        // A quarter of a small lamp is hidden at every point of the shadow's middle line; with one point of the lamp a sample, the pixel's samples must fill it together.
        Picture Render(int samples, double budget) => Renderer.Render(SoftShadow(samples), new RenderOptions
        {
            Width = 30, Height = 30, Samples = 4, Pattern = SamplePattern.Sobol, ErrorBudget = budget, MaxSamples = 4, Seed = 3,
        }).Picture;
        Picture converged = Render(1024, 0);
        double error = PictureAssert.Rmse(converged, Render(4, 1)), alike = PictureAssert.Rmse(converged, Render(4, 0));
        Assert.InRange(error, alike / 1.3, alike * 1.3);
        Assert.InRange(error, 0, PictureAssert.Rmse(converged, Render(2, 0)) / 1.2);
    }

    [Fact]
    public void Render_Crop_IsPartOfTheWholePicture()
    {
        Scene scene = TestScenes.Everything();
        Picture whole = Renderer.Render(scene, Options(0.03)).Picture;
        foreach (PixelRectangle crop in new PixelRectangle[] { new(5, 27, 40, 9), new(54, 39, 1, 1), new(32, 32, 23, 8) })
        {
            Picture part = Renderer.Render(scene, new RenderOptions { Width = Width, Height = Height, ErrorBudget = 0.03, Crop = crop }).Picture;
            for (int y = 0; y < crop.Height; y++)
            {
                Assert.True(part.Row(y).SequenceEqual(whole.Row(crop.Y + y).Slice(crop.X, crop.Width)), $"Row {y} of the crop {crop} differs.");
            }
        }
    }

    [Fact]
    public void ViewSamples_EdgesAndFlats_ShowTheirNumbers()
    {
        Picture view = Renderer.Render(Edges(), new RenderOptions { Width = Width, Height = Height, ErrorBudget = 0.01, View = RenderView.Samples }).Picture;
        Assert.Equal(new Intensity(0, 0, 1), view[0, 0]);
        Assert.True(view.Pixels.ToArray().Count(pixel => pixel.R == 1) > 20, "edges are sampled at least 16 times");
        Picture alike = Renderer.Render(Edges(), new RenderOptions { Width = 3, Height = 2, Samples = 16, View = RenderView.Samples }).Picture;
        Assert.All(alike.Pixels.ToArray(), pixel => Assert.Equal(new Intensity(1, 0, 0), pixel));
    }

    [Fact]
    public void Render_PixelsThatAreNoNumbers_DrawNoSamples()
    {
        Scene scene = Edges();
        scene.Background = Intensity.Grey(float.NaN);
        RenderStatistics statistics = Renderer.Render(scene, Options(0.01)).Statistics;
        Assert.True(statistics.NotFinitePixels > 500);
        Assert.True(statistics.PrimaryRays < 6 * Width * Height);
    }

    [Theory]
    [InlineData(-0.1)]
    [InlineData(1001)]
    [InlineData(double.NaN)]
    public void ErrorBudget_OutsideItsRange_IsRefused(double budget)
    {
        Assert.Contains("must be in [0, 1000]", Assert.Throws<ArgumentOutOfRangeException>(() => Options(budget)).Message, StringComparison.Ordinal);
        Assert.Throws<ArgumentOutOfRangeException>(() => Options(0.1, most: 3));
    }

    private static RenderOptions Options(double budget, int threads = 2, int most = 1024) =>
        new() { Width = Width, Height = Height, ErrorBudget = budget, MaxSamples = most, Threads = threads };

    /// <summary>Two shining balls before a dark ground.</summary>
    private static Scene Edges()
    {
        var scene = new Scene { Background = new Intensity(0.1f, 0.05f, 0.2f), Camera = new PerspectiveCamera(new Point3D(0, 0, 5), Point3D.Origin, 40) };
        scene.Add(new Sphere(new Point3D(0.31, 0.17, 0), 1.2), TestScenes.Shining(new Intensity(1, 0.8f, 0.3f)));
        scene.Add(new Sphere(new Point3D(-1.43, -0.29, 0.4), 0.6), TestScenes.Shining(new Intensity(0.2f, 0.5f, 1)));
        return scene;
    }

    /// <summary>A floor half in the shadow of a square lamp.</summary>
    private static Scene SoftShadow(int samples)
    {
        var scene = new Scene { Camera = TestScenes.AboveQuad() };
        scene.Add(new Quad(), new Material { Diffuse = Intensity.White, Ambient = Intensity.Black });
        scene.Add(new Quad(), new Material(), Transform.Translation(new Vector3D(0, 6, 1)));
        scene.Lights.Add(new QuadLight(new Point3D(-4, 12, -4), new Vector3D(8, 0, 0), new Vector3D(0, 0, 8), Intensity.White) { Samples = samples, Sides = LightSides.Both });
        return scene;
    }
}
