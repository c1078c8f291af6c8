namespace LabRaytracer.Tests.Rendering;

/// <summary>More samples for the pixels that edges of objects pass through.</summary>
public sealed class EdgeSamplesTests
{
    private const int Side = 40;

    // The wall covers all that is right of 20.25 pixels: three quarters of column 20.
    [Fact]
    public void Render_StraightEdge_CoversItsShareOfTheColumn()
    {
        RenderResult result = Render(Wall(), Options(64));
        for (int y = 0; y < Side; y++)
        {
            Assert.Equal(0, result.Picture[19, y].G);
            Assert.InRange(result.Picture[20, y].G, 0.75f - (1 / 32f), 0.75f + (1 / 32f));
            Assert.Equal(1, result.Picture[21, y].G);
        }

        Assert.Equal(Side, result.Statistics.EdgePixels);
        Assert.Equal((Side * Side) + (64 * Side), result.Statistics.PrimaryRays);
    }

    // A tent is two pixels wide, Mitchell's filter four: the pixels beside the column see the edge too.
    [Theory]
    [InlineData(PixelFilter.Box, 1)]
    [InlineData(PixelFilter.Tent, 3)]
    [InlineData(PixelFilter.Mitchell, 5)]
    public void Render_WiderFilters_SampleMoreColumns(PixelFilter filter, int columns)
    {
        RenderResult result = Render(Wall(), new RenderOptions { Width = Side, Height = Side, PixelFilter = filter, EdgeSamples = 16 });
        Assert.Equal(columns * Side, result.Statistics.EdgePixels);
        Assert.Equal(0, result.Picture[10, 10].G);
        Assert.Equal(1, result.Picture[30, 10].G, 1e-6f);
    }

    [Fact]
    public void Render_Balls_IsNearerToTheConvergedPictureThan16SamplesEverywhereWithATenthOfThem()
    {
        Picture converged = Render(Balls(), new RenderOptions { Width = Side, Height = Side, Samples = 1024, Pattern = SamplePattern.Sobol, Seed = 5 }).Picture;
        Picture alike = Render(Balls(), new RenderOptions { Width = Side, Height = Side, Samples = 16, Pattern = SamplePattern.Sobol }).Picture;
        RenderResult result = Render(Balls(), Options(16));
        Assert.InRange(PictureAssert.Rmse(converged, result.Picture), 0, 1.01 * PictureAssert.Rmse(converged, alike));
        Assert.InRange(result.Statistics.PrimaryRays, (Side * Side) + 1, 4 * Side * Side);
    }

    [Fact]
    public void Render_NoEdges_IsThePictureWithoutThem()
    {
        var scene = new Scene { Background = Intensity.Black };
        scene.Add(new InfinitePlane(new Point3D(0, 0, -3), Vector3D.UnitZ), TestScenes.Shining(Intensity.White));
        RenderResult result = Render(scene, Options(16));
        Assert.Equal(0, result.Statistics.EdgePixels);
        PictureAssert.SameBits(Render(scene, Options(1)).Picture, result.Picture);
    }

    [Fact]
    public void Render_PlaneToTheHorizon_HasOneEdge()
    {
        // The horizon passes through a row of pixels, 1/4 of a pixel above its middle; distances grow without end below it.
        var scene = new Scene { Background = Intensity.Black, Camera = new PerspectiveCamera(new Point3D(0, 1, 0), new Point3D(0, 1 - (0.25 / 20), -1), 90) };
        scene.Add(new InfinitePlane(Point3D.Origin, Vector3D.UnitY), TestScenes.Shining(Intensity.White));
        Assert.Equal(Side, Render(scene, Options(4)).Statistics.EdgePixels);
    }

    [Fact]
    public void Render_EdgeOfABox_IsFoundByItsTurn()
    {
        // The camera sees two sides of a box and nothing else; they meet in the middle column.
        var scene = new Scene { Camera = new PerspectiveCamera(new Point3D(9, 0.1, 9.1), Point3D.Origin, 5) };
        scene.Add(new Box(new Point3D(-1, -1, -1), new Point3D(1, 1, 1)), TestScenes.Shining(Intensity.White));
        Assert.InRange(Render(scene, Options(4)).Statistics.EdgePixels, Side, 2 * Side);
    }

    [Fact]
    public void Render_MeshBeforeItself_IsFoundByItsDistance()
    {
        // One mesh of two squares, one behind the other, both turned to the camera.
        double[] corners = [-9, -9, -4, 9, -9, -4, 9, 9, -4, -9, 9, -4, 0.01, -9, 0, 9, -9, 0, 9, 9, 0, 0.01, 9, 0];
        var scene = new Scene { Camera = new PerspectiveCamera(new Point3D(0, 0, 8), Point3D.Origin, 30) };
        scene.Add(new TriangleMesh(corners, [0, 1, 2, 0, 2, 3, 4, 5, 6, 4, 6, 7]), TestScenes.Shining(Intensity.White));
        Assert.Equal(Side, Render(scene, Options(4)).Statistics.EdgePixels);
    }

    [Fact]
    public void Render_AnyThreadsAndVectorWidth_SameBits()
    {
        Scene scene = TestScenes.Everything();
        scene.Lights.Add(new QuadLight(new Point3D(-1, 3, 2), new Vector3D(1, 0, 0), new Vector3D(0, 0, -1), Intensity.White) { Samples = 3 });
        Picture one = Renderer.Render(scene, Options(4), 1, null, default).Picture;
        PictureAssert.SameBits(one, Render(scene, Options(4)).Picture);
        PictureAssert.SameBits(one, Renderer.Render(scene, Options(4), 4, null, default).Picture);
        PictureAssert.SameBits(one, Renderer.Render(scene, Options(4), 8, null, default).Picture);
        PictureAssert.SameBits(one, Renderer.Render(scene, Options(4), 16, null, default).Picture);
    }

    [Theory]
    [InlineData(PixelFilter.Box)]
    [InlineData(PixelFilter.Tent)]
    public void Render_Crop_IsPartOfTheWholePicture(PixelFilter filter)
    {
        RenderOptions Options(PixelRectangle? crop) => new() { Width = Side, Height = Side, EdgeSamples = 8, PixelFilter = filter, Crop = crop };
        Picture whole = Render(Balls(), Options(null)).Picture;
        foreach (PixelRectangle crop in new PixelRectangle[] { new(5, 27, 30, 9), new(16, 3, 17, 35), new(39, 39, 1, 1) })
        {
            Picture part = Render(Balls(), Options(crop)).Picture;
            for (int y = 0; y < crop.Height; y++)
            {
                Assert.True(part.Row(y).SequenceEqual(whole.Row(crop.Y + y).Slice(crop.X, crop.Width)), $"Row {y} of the crop {crop} differs.");
            }
        }
    }

    [Fact]
    public void Render_Budget_DecidesAlone()
    {
        RenderOptions With(int edgeSamples) => new() { Width = Side, Height = Side, ErrorBudget = 0.02, EdgeSamples = edgeSamples };
        RenderResult result = Render(Balls(), With(64));
        Assert.Equal(0, result.Statistics.EdgePixels);
        PictureAssert.SameBits(Render(Balls(), With(1)).Picture, result.Picture);
    }

    [Fact]
    public void ViewSamples_Edge_ShowsItsNumber()
    {
        Picture view = Render(Wall(), new RenderOptions { Width = Side, Height = Side, EdgeSamples = 16, View = RenderView.Samples }).Picture;
        Assert.Equal(Intensity.Black, view[19, 5]);
        Assert.Equal(new Intensity(1, 0, 0), view[20, 5]);
    }

    [Theory]
    [InlineData(0)]
    [InlineData(65537)]
    public void EdgeSamples_OutsideTheirRange_AreRefused(int samples) =>
        Assert.Contains("Allowed: 1 to 65536", Assert.Throws<ArgumentOutOfRangeException>(() => Options(samples)).Message, StringComparison.Ordinal);

    private static RenderOptions Options(int edgeSamples) => new() { Width = Side, Height = Side, EdgeSamples = edgeSamples };

    private static RenderResult Render(Scene scene, RenderOptions options) => Renderer.Render(scene, options);

    /// <summary>A shining wall at distance 1 that begins a quarter of a pixel right of the middle; pixels are 1/20 there.</summary>
    private static Scene Wall()
    {
        var scene = new Scene { Background = Intensity.Black, Camera = new PerspectiveCamera(new Point3D(0, 0, 1), Point3D.Origin, 90) };
        scene.Add(new Quad(new Point3D(0.25 / 20, -9, 0), new Vector3D(0, 18, 0), new Vector3D(9, 0, 0)), TestScenes.Shining(Intensity.White));
        return scene;
    }

    /// <summary>Two shining balls before a dark ground.</summary>
    private static Scene Balls()
    {
        var scene = new Scene { Background = new Intensity(0.1f, 0.05f, 0.2f), Camera = new PerspectiveCamera(new Point3D(0, 0, 5), Point3D.Origin, 40) };
        scene.Add(new Sphere(new Point3D(0.31, 0.17, 0), 1.2), TestScenes.Shining(new Intensity(1, 0.8f, 0.3f)));
        scene.Add(new Sphere(new Point3D(-1.43, -0.29, 0.4), 0.6), TestScenes.Shining(new Intensity(0.2f, 0.5f, 1)));
        return scene;
    }
}
