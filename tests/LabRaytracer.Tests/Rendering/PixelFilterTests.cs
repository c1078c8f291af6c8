namespace LabRaytracer.Tests.Rendering;

/// <summary>Pixel filters and sample patterns.</summary>
public sealed class PixelFilterTests
{
    // mpmath: where the integral of the absolute value of Mitchell and Netravali's cubic (B = C = 1/3) reaches the share; the table of 1024 steps is straight between them.
    [Theory]
    [InlineData(0.5, 0.5)]
    [InlineData(0.6, 0.6216500603342938)]
    [InlineData(0.75, 0.8225449210424041)]
    [InlineData(0.9, 1.1020370455028253)]
    [InlineData(0.98, 1.4946769643687274)]
    [InlineData(0.01, -0.91937259698913909)]
    public void Place_Mitchell_InvertsTheAbsoluteArea(double even, double expected) =>
        Assert.Equal(expected, new PixelWarp(PixelFilter.Mitchell).Place(even), 2e-5);

    [Theory]
    [InlineData(0.5, 0.5)]
    [InlineData(0.125, 0)]
    [InlineData(0.875, 1)]
    [InlineData(0.0, -0.5)]
    public void Place_Tent_InvertsTheArea(double even, double expected) => Assert.Equal(expected, new PixelWarp(PixelFilter.Tent).Place(even), 1e-15);

    [Fact]
    public void Gain_OfFilters_IsTheirAbsoluteArea()
    {
        Assert.Equal((1, 1), (new PixelWarp(PixelFilter.Box).Gain, new PixelWarp(PixelFilter.Tent).Gain));
        Assert.Equal(1.1448376101794320, new PixelWarp(PixelFilter.Mitchell).Gain, 1e-14);
    }

    // mpmath: integral of the filter from d to infinity, d in pixels to the right of the pixel's centre.
    [Theory]
    [InlineData(PixelFilter.Box, 0.25, 0.25)]
    [InlineData(PixelFilter.Box, 0.75, 0)]
    [InlineData(PixelFilter.Tent, 0.0, 0.5)]
    [InlineData(PixelFilter.Tent, 0.5, 0.125)]
    [InlineData(PixelFilter.Tent, -0.75, 0.96875)]
    [InlineData(PixelFilter.Mitchell, 0.0, 0.5)]
    [InlineData(PixelFilter.Mitchell, 0.25, 0.28705512152777778)]
    [InlineData(PixelFilter.Mitchell, 0.5, 0.12065972222222222)]
    [InlineData(PixelFilter.Mitchell, 1.0, -0.013888888888888889)]
    [InlineData(PixelFilter.Mitchell, 1.25, -0.01611328125)]
    [InlineData(PixelFilter.Mitchell, -1.25, 1.01611328125)]
    public void Render_StraightEdge_IsTheFiltersIntegral(PixelFilter filter, double distance, double expected)
    {
        // 8 x 8 pixels of 1/4 unit; the quad begins at the centre of pixel 4 plus the distance. An error is at most one column of samples.
        foreach ((SamplePattern pattern, int side) in new[] { (SamplePattern.Regular, 128), (SamplePattern.Jittered, 32), (SamplePattern.Sobol, 32) })
        {
            Picture pixel = Renderer.Render(HalfPlane(0.125 + (0.25 * distance)), new RenderOptions
            {
                Width = 8, Height = 8, Samples = side * side, Pattern = pattern, PixelFilter = filter, Crop = new PixelRectangle(4, 4, 1, 1),
            }).Picture;
            Assert.Equal(expected, pixel[0, 0].G, 1.1448 / side);
        }
    }

    [Theory]
    [InlineData(PixelFilter.Box, SamplePattern.Jittered)]
    [InlineData(PixelFilter.Tent, SamplePattern.Jittered)]
    [InlineData(PixelFilter.Mitchell, SamplePattern.Regular)]
    [InlineData(PixelFilter.Mitchell, SamplePattern.Jittered)]
    [InlineData(PixelFilter.Mitchell, SamplePattern.Sobol)]
    [InlineData(PixelFilter.Mitchell, SamplePattern.MultiJittered)]
    public void Render_ConstantPicture_StaysConstant(PixelFilter filter, SamplePattern pattern)
    {
        foreach (int samples in new[] { 1, 4, 9, 16 })
        {
            Picture picture = Renderer.Render(
                new Scene { Background = new Intensity(0.3f, 0.6f, 12) }, new RenderOptions { Width = 40, Height = 3, Samples = samples, Pattern = pattern, PixelFilter = filter }).Picture;
            Assert.All(picture.Pixels.ToArray(), pixel => Assert.Equal(1, pixel.B / 12, 1e-6f));
        }
    }

    [Fact]
    public void Render_OneRegularSample_IsTheCentreWithAnyFilter()
    {
        Picture Render(PixelFilter filter) => Renderer.Render(
            TestScenes.QuadFromAbove(TestScenes.Shining(TestScenes.Random(9, 7))), new RenderOptions { Width = 50, Height = 40, PixelFilter = filter }).Picture;
        PictureAssert.SameBits(Render(PixelFilter.Box), Render(PixelFilter.Tent));
        Picture box = Render(PixelFilter.Box), mitchell = Render(PixelFilter.Mitchell);
        for (int i = 0; i < 50 * 40; i++)
        {
            Assert.Equal(box.Pixels[i].G, mitchell.Pixels[i].G, 1e-6f);
        }
    }

    [Theory]
    [InlineData(4)]
    [InlineData(16)]
    [InlineData(64)]
    public void Sobol_PowerOfTwo_EveryDivisionIntoEqualRectanglesHoldsOneEach(int samples)
    {
        RenderOptions options = new() { Seed = 11 };
        for (int pixel = 0; pixel < 20; pixel++)
        {
            for (int columns = 1; columns <= samples; columns *= 2)
            {
                int rows = samples / columns;
                var cells = Enumerable.Range(0, samples).Select(sample =>
                    ((int)(columns * SampleOffsets.Sobol(options, pixel, 7, sample, 0)), (int)(rows * SampleOffsets.Sobol(options, pixel, 7, sample, 1))));
                Assert.Equal(samples, cells.Distinct().Count());
            }
        }
    }

    [Fact]
    public void Sobol_FirstSampleOfManyPixels_IsEven()
    {
        const int Count = 20000;
        double sum = Enumerable.Range(0, Count).Sum(pixel => SampleOffsets.Sobol(new RenderOptions(), pixel % 200, pixel / 200, 0, 1) - 0.5);
        Assert.InRange(sum / Count, -5 / Math.Sqrt(12.0 * Count), 5 / Math.Sqrt(12.0 * Count));
    }

    /// <summary>White to the right of an edge, black to its left.</summary>
    private static Scene HalfPlane(double edge)
    {
        var scene = new Scene { Camera = TestScenes.AboveQuad() };
        scene.Add(new Quad(), TestScenes.Shining(Intensity.White), Transform.Translation(new Vector3D(0, 0, edge + 1)));
        return scene;
    }
}
