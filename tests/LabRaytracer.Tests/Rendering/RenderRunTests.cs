namespace LabRaytracer.Tests.Rendering;

/// <summary>Progress, cancellation, failures and pixels that are not finite.</summary>
public sealed class RenderRunTests
{
    [Fact]
    public void Render_CancelledBefore_Throws()
    {
        using CancellationTokenSource source = new();
        source.Cancel();
        Assert.Throws<OperationCanceledException>(() => Renderer.Render(TestScenes.Everything(), cancellation: source.Token));
    }

    [Theory]
    [InlineData(1)]
    [InlineData(3)]
    public void Render_CancelledMeanwhile_StopsBetweenTiles(int threads)
    {
        using CancellationTokenSource source = new();
        Heard heard = new(share => source.Cancel());
        RenderOptions options = new() { Width = 640, Height = 640, Threads = threads };
        Assert.ThrowsAny<OperationCanceledException>(() => Renderer.Render(TestScenes.QuadFromAbove(new Material()), options, heard, source.Token));
        Assert.InRange(heard.Shares.Count, 1, threads);
    }

    [Theory]
    [InlineData(1)]
    [InlineData(2)]
    public void Render_Progress_ReachesOne(int threads)
    {
        Heard heard = new(_ => { });
        Renderer.Render(TestScenes.Everything(), new RenderOptions { Width = 70, Height = 40, Threads = threads }, heard);
        Assert.Equal([1.0 / 6, 2.0 / 6, 3.0 / 6, 4.0 / 6, 5.0 / 6, 1], heard.Shares.Order());
    }

    [Theory]
    [InlineData(1)]
    [InlineData(2)]
    public void Render_StudentsCodeThrows_SaysWhereAndWhat(int threads)
    {
        Scene scene = TestScenes.QuadFromAbove(TestScenes.Shining(TextureSlot.Of(new Broken())));
        RenderException failure = Assert.Throws<RenderException>(() => Renderer.Render(scene, new RenderOptions { Width = 40, Height = 40, Threads = threads }));
        Assert.IsType<IndexOutOfRangeException>(failure.InnerException);
        Assert.Contains("tile", failure.Message, StringComparison.Ordinal);
        Assert.Contains("row 7", failure.Message, StringComparison.Ordinal);
    }

    [Fact]
    public void Render_TextureWithOneNan_CountsAndLocatesThePixel()
    {
        Texture texture = TestScenes.Random(8, 8).With(new SamplingOptions { Filter = TextureFilter.Nearest });
        texture.ColorMap[3, 2] = new Intensity(0, float.NaN, 0);
        Scene scene = TestScenes.QuadFromAbove(TestScenes.Shining(texture));
        RenderResult result = Renderer.Render(scene, new RenderOptions { Width = 8, Height = 8 });
        Assert.Equal((1, (3, 5)), (result.Statistics.NotFinitePixels, result.Statistics.FirstNotFinitePixel!.Value));
        Assert.Equal(Intensity.Black, result.Picture[3, 5]);
        Picture marked = Renderer.Render(scene, new RenderOptions { Width = 8, Height = 8, View = RenderView.Nan }).Picture;
        Assert.Equal(1, marked.Pixels.ToArray().Count(pixel => pixel == new Intensity(1, 0, 1)));
        Assert.Equal(new Intensity(1, 0, 1), marked[3, 5]);
    }

    [Theory]
    [InlineData(TextureWrap.Repeat)]
    [InlineData(TextureWrap.Clamp)]
    [InlineData(TextureWrap.Mirror)]
    public void Render_StudentsMappingGivesNan_CountsThePixels(TextureWrap wrap)
    {
        foreach (double number in new[] { double.NaN, double.PositiveInfinity, double.NegativeInfinity })
        {
            Texture texture = TestScenes.Random(5, 4).With(new SamplingOptions { WrapU = wrap, WrapV = wrap });
            Scene scene = TestScenes.QuadFromAbove(TestScenes.Shining(new TextureSlot { Texture = texture, Mapping = new Lost(number) }));
            RenderStatistics statistics = Renderer.Render(scene, new RenderOptions { Width = 40, Height = 40, Threads = 1 }).Statistics;
            Assert.Equal(1600, statistics.NotFinitePixels);
        }
    }

    [Fact]
    public void Render_FiniteScene_HasNoPixelThatIsNotFinite()
    {
        RenderStatistics statistics = Renderer.Render(TestScenes.Everything(), new RenderOptions { Width = 60, Height = 40 }).Statistics;
        Assert.Equal(0, statistics.NotFinitePixels);
        Assert.Null(statistics.FirstNotFinitePixel);
    }

    [Theory]
    [InlineData(0)]
    [InlineData(2)]
    [InlineData(-1)]
    [InlineData(65537)]
    public void Samples_NotASquare_AreRefused(int samples)
    {
        ArgumentOutOfRangeException failure = Assert.Throws<ArgumentOutOfRangeException>(() => new RenderOptions { Samples = samples });
        Assert.Contains("1, 4, 9, 16, 25, ... up to 65536", failure.Message, StringComparison.Ordinal);
    }

    [Fact]
    public void Options_OutsideTheirRanges_AreRefused()
    {
        Assert.Throws<ArgumentOutOfRangeException>(() => new RenderOptions { Width = 0 });
        Assert.Throws<ArgumentOutOfRangeException>(() => new RenderOptions { Height = RenderOptions.MaxSide + 1 });
        Assert.Throws<ArgumentOutOfRangeException>(() => new RenderOptions { Threads = 0 });
        Assert.Throws<ArgumentOutOfRangeException>(() => new RenderOptions { MaxDepth = 65 });
        Assert.Throws<ArgumentNullException>(() => Renderer.Render(null!));
    }

    [Fact]
    public void Views_ShowWhatTheySay()
    {
        Scene scene = TestScenes.QuadFromAbove(new Material());
        Picture Show(RenderView view) => Renderer.Render(scene, new RenderOptions { Width = 4, Height = 4, View = view }).Picture;
        PictureAssert.Near(new Intensity(0.125f, 0.875f, 0), Show(RenderView.Uv)[0, 0], 1e-7, "uv");
        PictureAssert.Near(new Intensity(0.5f, 1, 0.5f), Show(RenderView.Normal)[1, 2], 1e-7, "normal");
        PictureAssert.Near(Intensity.Grey(1f / 6), Show(RenderView.Depth)[1, 2], 1e-7, "depth");
        Assert.Equal(Show(RenderView.Object)[0, 0], Show(RenderView.Object)[3, 3]);
    }

    private sealed class Heard(Action<double> action) : IProgress<double>
    {
        private readonly Lock _lock = new();

        public List<double> Shares { get; } = [];

        public void Report(double value)
        {
            lock (_lock)
            {
                Shares.Add(value);
            }

            action(value);
        }
    }

    private sealed class Lost(double number) : IMapping
    {
        public TextureCoordinate Map(in SurfacePosition position) => new(number, 0.5);
    }

    private sealed class Broken : ITexture
    {
        public Intensity Sample(in TextureLookup lookup) => throw new IndexOutOfRangeException("there is no row 7");
    }

    /// <summary>Samples lie at the same place whatever part of the picture is rendered, to the last bit, which the colours here show; thirds and fifths of a pixel are no binary numbers.</summary>
    [Theory]
    [InlineData(9, Precision.Double)]
    [InlineData(25, Precision.Double)]
    [InlineData(25, Precision.Single)]
    public void Render_CropThatBeginsAnywhere_HasTheSamplesOfTheWhole(int samples, Precision precision)
    {
        FunctionTexture bits = new(lookup => Intensity.Grey((float)(BitConverter.DoubleToUInt64Bits(lookup.LocalPoint.X) % 1021)) + Intensity.Grey((float)(BitConverter.DoubleToUInt64Bits(lookup.LocalPoint.Z) % 1019)));
        Scene scene = TestScenes.QuadFromAbove(TestScenes.Shining(TextureSlot.Of(bits)));
        Picture Show(PixelRectangle? crop) => Renderer.Render(scene, new RenderOptions { Width = 80, Height = 60, Samples = samples, Precision = precision, Crop = crop }).Picture;
        Picture whole = Show(null), part = Show(new PixelRectangle(11, 7, 50, 40));
        for (int y = 0; y < part.Height; y++)
        {
            Assert.Equal(whole.Row(y + 7).Slice(11, part.Width).ToArray(), part.Row(y).ToArray());
        }
    }
}
