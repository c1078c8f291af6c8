namespace LabRaytracer.Tests;

public sealed class PictureTests
{
    [Theory]
    [InlineData(0, 1)]
    [InlineData(1, 0)]
    [InlineData(-1, 5)]
    [InlineData(1048577, 1)]
    [InlineData(1048576, 1048576)]
    public void New_SideOutOfRange_Throws(int width, int height) =>
        Assert.Throws<ArgumentOutOfRangeException>(() => new Picture(width, height));

    [Fact]
    public void Indexer_OutsideOfThePicture_Throws()
    {
        Picture picture = new(3, 2);
        picture[2, 1] = Intensity.White;
        Assert.Equal(Intensity.White, picture.Row(1)[2]);
        Assert.Throws<ArgumentOutOfRangeException>(() => picture[3, 0]);
        Assert.Throws<ArgumentOutOfRangeException>(() => picture[0, 2]);
        Assert.Throws<ArgumentOutOfRangeException>(() => picture[-1, 0]);
        Assert.Throws<ArgumentOutOfRangeException>(() => picture.Row(2));
    }

    [Fact]
    public void Load_AnyExtension_GoesByContent()
    {
        using TestFolder folder = new();
        Picture picture = PngWriteTests.Pattern(5, 4);
        picture.Save(folder["a.png"]);
        File.Move(folder["a.png"], folder["a.ppm"]);
        Assert.Equal(5, Picture.Load(folder["a.ppm"]).Width);
    }

    [Fact]
    public void Save_FailureWhileWriting_KeepsTheOldFileAndLeavesNothingElse()
    {
        using TestFolder folder = new();
        File.WriteAllText(folder["a.png"], "old");
        PictureCodecs codecs = PictureCodecs.Default.With(new FailingCodec());
        Assert.Throws<IOException>(() => codecs.Write(new Picture(2, 2), folder["a.png"]));
        Assert.Equal("old", File.ReadAllText(folder["a.png"]));
        Assert.Equal(["a.png"], folder.Files);
    }

    [Fact]
    public void Save_OverAnOldFile_ReplacesItAndLeavesNothingElse()
    {
        using TestFolder folder = new();
        File.WriteAllText(folder["a.png"], new string('x', 100000));
        PngWriteTests.Pattern(5, 4).Save(folder["a.png"]);
        Assert.Equal(4, Picture.Load(folder["a.png"]).Height);
        Assert.Equal(["a.png"], folder.Files);
    }

    [Fact]
    public void Save_ThroughALink_KeepsTheLink()
    {
        if (OperatingSystem.IsWindows())
        {
            return; // Links need a privilege there.
        }

        using TestFolder folder = new();
        File.WriteAllText(folder["real.png"], "old");
        File.CreateSymbolicLink(folder["link.png"], folder["real.png"]);
        new Picture(2, 2).Save(folder["link.png"]);
        Assert.Equal(folder["real.png"], new FileInfo(folder["link.png"]).LinkTarget);
        Assert.Equal(2, Picture.Load(folder["real.png"]).Width);
    }

    [Fact]
    public void Save_ImpossibleTarget_SaysWhy()
    {
        using TestFolder folder = new();
        Directory.CreateDirectory(folder["b.png"]);
        Picture picture = new(2, 2);
        Assert.Contains("create it", Assert.Throws<IOException>(() => picture.Save(folder["no/such/a.png"])).Message, StringComparison.Ordinal);
        Assert.Contains("folder", Assert.Throws<IOException>(() => picture.Save(folder["b.png"])).Message, StringComparison.Ordinal);
        Assert.Contains(".png", Assert.Throws<ArgumentException>(() => picture.Save(folder["a.xyz"])).Message, StringComparison.Ordinal);
        Assert.Throws<IOException>(() => PictureCodecs.Default.CheckTarget(folder["no/a.png"]));
        PictureCodecs.Default.CheckTarget(folder["good.png"]);
        Assert.Empty(folder.Files);
    }

    [Fact]
    public void Save_FullDevice_Throws()
    {
        if (File.Exists("/dev/full"))
        {
            Assert.Throws<IOException>(() => AtomicFile.Write("/dev/full", stream => stream.Write(new byte[10])));
            Assert.True(File.Exists("/dev/full"));
        }
    }

    [Fact]
    public void FromPixels_EveryFormat_DecodesToLinear()
    {
        Intensity half = new(ColorEncoding.LinearFromSrgb8(128), 0, 1);
        Assert.Equal(half, One(PixelBuffer.FromRgba8(1, 1, [128, 0, 255, 9], TransferFunction.Srgb, "t")));
        Assert.Equal(half, One(PixelBuffer.FromRgba16(1, 1, [128 * 257, 0, 65535, 9], TransferFunction.Srgb, "t")));
        Assert.Equal(new Intensity(2, -1, 0.5f), One(PixelBuffer.FromRgbaFloat(1, 1, [2, -1, 0.5f, 1], TransferFunction.Linear, "t")));
        Assert.Equal(new Intensity(0.25f, 0, 1), One(PixelBuffer.FromRgbaFloat(1, 1, [0.5f, 0, 1, 1], TransferFunction.Gamma(2), "t")));
        Assert.Throws<ArgumentException>(() => PixelBuffer.FromRgba8(1, 2, new byte[4], TransferFunction.Srgb, "t"));
    }

    [Fact]
    public void ToneMapping_Operators_FollowTheirFormulas()
    {
        Assert.Equal(new Intensity(0, 0.5f, 1), new ToneMapping().Apply(new Intensity(-1, 0.5f, 2)));
        Assert.Equal(new Intensity(0, 1, 1), new ToneMapping { Exposure = 1 }.Apply(new Intensity(float.NaN, 0.5f, 2)));
        ToneMapping reinhard = new() { Operator = ToneOperator.Reinhard, Exposure = -1 };
        Assert.Equal(new Intensity(0.5f, 0.75f, 1), reinhard.Apply(new Intensity(2, 6, float.PositiveInfinity)));
        Assert.Throws<ArgumentOutOfRangeException>(() => new ToneMapping { Exposure = double.NaN });
    }

    // The quotient in exact arithmetic.
    [Theory]
    [InlineData(0, 0)]
    [InlineData(0.1f, 0.12583968021036654)]
    [InlineData(0.5f, 0.6163069544364509)]
    [InlineData(1, 0.80379746835443038)]
    [InlineData(7.5f, 1)]
    [InlineData(float.PositiveInfinity, 1)]
    [InlineData(float.NaN, 0)]
    public void ToneMapping_Aces_IsTheFittedQuotient(float light, double expected) =>
        Assert.Equal(expected, new ToneMapping { Operator = ToneOperator.Aces }.Apply(light), 1e-7);

    [Theory]
    [InlineData("")]
    [InlineData(" a")]
    [InlineData("a  b")]
    [InlineData("é")]
    public void Text_WrongKey_Throws(string key) =>
        Assert.Throws<ArgumentException>(() => new PictureSaveOptions { Text = [new(key, "x")] });

    private static Intensity One(PixelBuffer buffer) => Picture.FromPixels(buffer)[0, 0];

    private sealed class FailingCodec : IPictureCodec
    {
        public string Name => "failing";

        public IReadOnlyList<string> Extensions => [".png"];

        public bool CanWrite => true;

        public bool CanRead(ReadOnlySpan<byte> header) => false;

        public PixelBuffer Read(Stream stream, PictureLimits limits, string name) => throw new PictureFormatException(name, "never read");

        public void Write(Picture picture, Stream stream, PictureSaveOptions options)
        {
            stream.Write(new byte[100000]);
            throw new IOException("disk full");
        }
    }
}
