namespace LabRaytracer.Tests.Rendering;

/// <summary>Pictures that are handed over in bands are those that are held as a whole.</summary>
public sealed class BandTests
{
    [Theory]
    [InlineData(1, 70, 200)]
    [InlineData(3, 70, 200)]
    [InlineData(8, 3000, 70)]
    [InlineData(2, 5, 5)]
    public void Render_InBands_WritesTheSameFile(int threads, int width, int height)
    {
        RenderOptions options = new() { Width = width, Height = height, Threads = threads };
        using MemoryStream whole = new(), bands = new();
        new PngCodec().Write(Renderer.Render(Ball(), options).Picture, whole, PictureSaveOptions.Default);
        PngRowWriter writer = new(bands, width, height, PictureSaveOptions.Default);
        Renderer.Render(Ball(), options, writer);
        writer.Finish();
        Assert.Equal(whole.ToArray(), bands.ToArray());
    }

    [Fact]
    public void Render_CropInBands_IsThatPartOfThePicture()
    {
        PixelRectangle crop = new(13, 21, 50, 90);
        RenderOptions options = new() { Width = 100, Height = 140, Threads = 3, Crop = crop };
        Recorder recorder = new();
        Renderer.Render(Ball(), options, recorder);
        Assert.Equal(Renderer.Render(Ball(), options).Picture.Pixels.ToArray(), recorder.Pixels);
    }

    [Theory]
    [InlineData(1)]
    [InlineData(4)]
    public void Render_SinkFails_EndsWithItsFailure(int threads)
    {
        Recorder full = new() { Room = 3 };
        RenderOptions options = new() { Width = 100, Height = 2000, Threads = threads };
        IOException failure = Assert.Throws<IOException>(() => Renderer.Render(Ball(), options, full));
        Assert.Equal("no room", failure.Message);
    }

    [Fact]
    public void Render_CancelledInBands_Ends()
    {
        using CancellationTokenSource source = new();
        Recorder cancelling = new() { Taken = source.Cancel };
        RenderOptions options = new() { Width = 100, Height = 2000, Threads = 4 };
        Assert.ThrowsAny<OperationCanceledException>(() => Renderer.Render(Ball(), options, cancelling, null, source.Token));
    }

    private static Scene Ball()
    {
        Scene scene = new() { Background = new Intensity(0.1f, 0.2f, 0.3f) };
        scene.Add(new Sphere(), Material.Matte(new CheckerTexture()));
        scene.Lights.Add(new PointLight(new Point3D(3, 4, 5), Intensity.White));
        return scene;
    }

    /// <summary>Keeps the pixels in the order in which they are handed over.</summary>
    private sealed class Recorder : IBandSink
    {
        private readonly List<Intensity> _pixels = [];
        private int _bands;

        public int BandRows => 32;

        public int Room { get; init; } = int.MaxValue;

        public Action Taken { get; init; } = () => { };

        public Intensity[] Pixels => [.. _pixels];

        public Action Prepare(ReadOnlySpan<Intensity> rows)
        {
            Intensity[] copy = rows.ToArray();
            return () =>
            {
                if (++_bands > Room)
                {
                    throw new IOException("no room");
                }

                _pixels.AddRange(copy);
                Taken();
            };
        }
    }
}
