namespace LabRaytracer.Tests;

public sealed class PngReadTests
{
    public static TheoryData<int, int, bool> Forms()
    {
        TheoryData<int, int, bool> forms = [];
        foreach ((int type, int[] depths) in new (int, int[])[] { (0, [1, 2, 4, 8, 16]), (2, [8, 16]), (3, [1, 2, 4, 8]), (4, [8, 16]), (6, [8, 16]) })
        {
            foreach (int depth in depths)
            {
                forms.Add(type, depth, false);
                forms.Add(type, depth, true);
            }
        }

        return forms;
    }

    [Theory]
    [MemberData(nameof(Forms))]
    public void Read_EveryFormAndOddSizes_GivesEverySampleExactly(int type, int depth, bool interlaced)
    {
        foreach ((int width, int height) in new[] { (1, 1), (2, 3), (5, 1), (1, 9), (4, 4), (7, 8), (8, 5), (33, 17), (130, 11) })
        {
            TestPng png = Create(type, depth, interlaced, width, height, withTransparency: false);
            AssertSamples(png, Read(png.ToBytes()), hasTransparency: false);
        }
    }

    [Theory]
    [MemberData(nameof(Forms))]
    public void Read_WithTransparencyChunk_GivesAlpha(int type, int depth, bool interlaced)
    {
        if (type is 0 or 2 or 3)
        {
            TestPng png = Create(type, depth, interlaced, 19, 13, withTransparency: true);
            PixelBuffer buffer = Read(png.ToBytes());
            AssertSamples(png, buffer, hasTransparency: true);
            Assert.True(buffer.HasAlpha);
        }
    }

    [Theory]
    [InlineData(1)]
    [InlineData(7)]
    public void Read_ManySmallImageDataChunks_GivesTheSamePicture(int size)
    {
        TestPng png = Create(2, 8, false, 20, 10, withTransparency: false, size);
        AssertSamples(png, Read(png.ToBytes()), hasTransparency: false);
    }

    [Theory]
    [InlineData(2, 8, false)]
    [InlineData(6, 16, false)]
    [InlineData(2, 8, true)]
    public void Read_ManyBlocksOfRows_GivesEverySample(int type, int depth, bool interlaced)
    {
        // So large that rows are unfiltered on another thread than they are inflated on.
        TestPng png = Create(type, depth, interlaced, 301, 1201, withTransparency: false);
        AssertSamples(png, Read(png.ToBytes()), hasTransparency: false);
    }

    [Fact]
    public void Read_GreyAndColouredFiles_TellsGrey()
    {
        Assert.True(Read(Create(0, 8, false, 9, 9, false).ToBytes()).IsGrey);
        Assert.False(Read(Create(2, 8, false, 9, 9, false).ToBytes()).IsGrey);
        Assert.False(Read(Create(2, 8, false, 9, 9, false).ToBytes()).HasAlpha);
    }

    [Fact]
    public void Read_ColourChunks_StrongestWins()
    {
        byte[] gamma22 = [0, 0, 0xB1, 0x8F];
        byte[] gammaLinear = [0, 1, 0x86, 0xA0];
        byte[] profile = [.. "Camera RGB\0"u8, 0, 1, 2, 3];
        byte[] srgbProfile = [.. "sRGB IEC61966-2.1\0"u8, 0, 1, 2, 3];
        AssertTransfer(TransferFunction.Srgb, "assumed");
        AssertTransfer(TransferFunction.Gamma(100000.0 / 45455), "gAMA", ("gAMA", gamma22));
        AssertTransfer(TransferFunction.Linear, "gAMA", ("gAMA", gammaLinear));
        AssertTransfer(TransferFunction.Srgb, "sRGB chunk", ("gAMA", gammaLinear), ("sRGB", [0]));
        AssertTransfer(TransferFunction.Linear, "cICP", ("gAMA", gamma22), ("sRGB", [0]), ("cICP", [1, 8, 0, 1]));
        AssertTransfer(TransferFunction.Srgb, "iCCP profile 'sRGB", ("iCCP", srgbProfile));
        AssertTransfer(TransferFunction.Srgb, "not interpreted", ("iCCP", profile));
        AssertTransfer(TransferFunction.Srgb, "16", ("cICP", [9, 16, 0, 1]));
        AssertTransfer(TransferFunction.Srgb, "assumed", ("gAMA", [0, 0, 0, 0]));

        // White point and primaries of sRGB as PNG writers round them, then those of Adobe RGB (1998), whose green lies at (0.21, 0.71).
        byte[] own = Words(31270, 32900, 64000, 33000, 30000, 60000, 15000, 6000), other = Words(31270, 32900, 64000, 33000, 21000, 71000, 15000, 6000);
        Assert.Equal("assumed", AssertTransfer(TransferFunction.Srgb, "assumed", ("cHRM", own)));
        Assert.Equal("gAMA chunk", AssertTransfer(TransferFunction.Linear, "gAMA", ("gAMA", gammaLinear), ("cHRM", own)));
        AssertTransfer(TransferFunction.Linear, "primaries are not those of sRGB and not converted", ("gAMA", gammaLinear), ("cHRM", other));
        AssertTransfer(TransferFunction.Srgb, "primaries are not those of sRGB and not converted", ("cHRM", other));
        Assert.Equal("sRGB chunk", AssertTransfer(TransferFunction.Srgb, "sRGB chunk", ("cHRM", other), ("sRGB", [0])));
    }

    [Fact]
    public void WithTransfer_ExplicitChoice_WinsAndSharesSamples()
    {
        PixelBuffer buffer = Read(Create(2, 8, false, 3, 3, false).ToBytes());
        PixelBuffer linear = buffer.WithTransfer(TransferFunction.Linear);
        Assert.Same(buffer.Rgba8, linear.Rgba8);
        Assert.True(linear.Transfer.IsLinear);
    }

    private static byte[] Words(params int[] numbers) => [.. numbers.SelectMany(number => new[] { (byte)(number >> 24), (byte)(number >> 16), (byte)(number >> 8), (byte)number })];

    private static string AssertTransfer(TransferFunction expected, string source, params (string Type, byte[] Content)[] chunks)
    {
        TestPng png = Create(0, 8, false, 2, 2, false);
        png.Chunks.AddRange(chunks);
        PixelBuffer buffer = Read(png.ToBytes());
        Assert.Equal(expected, buffer.Transfer);
        Assert.Contains(source, buffer.TransferSource, StringComparison.Ordinal);
        return buffer.TransferSource;
    }

    internal static TestPng Create(int type, int depth, bool interlaced, int width, int height, bool withTransparency, int idatSize = int.MaxValue)
    {
        // A palette of 2^depth - 1 colours, so that its length differs from the number of codes.
        int codes = type == 3 && depth > 1 ? (1 << depth) - 1 : 1 << depth;
        TestPng png = new()
        {
            Width = width,
            Height = height,
            Type = type,
            Depth = depth,
            Interlaced = interlaced,
            IdatSize = idatSize,
            Sample = (x, y, c) => (int)(((uint)((x * 7919) + (y * 104729) + (c * 1299709)) * 2654435761u) >> 8) % codes,
        };
        if (type == 3)
        {
            png.Chunks.Add(("PLTE", [.. Enumerable.Range(0, 3 * codes).Select(i => (byte)(i * 37))]));
        }

        if (withTransparency)
        {
            byte[] key = [.. Enumerable.Range(0, png.Channels).SelectMany(c => new[] { (byte)(png.Sample(1, 1, c) >> 8), (byte)png.Sample(1, 1, c) })];
            png.Chunks.Add(("tRNS", type == 3 ? [7, 200] : key));
        }

        return png;
    }

    private static void AssertSamples(TestPng png, PixelBuffer buffer, bool hasTransparency)
    {
        Assert.Equal((png.Width, png.Height), (buffer.Width, buffer.Height));
        Assert.Equal(png.Depth == 16 ? PixelFormat.Rgba16 : PixelFormat.Rgba8, buffer.Format);
        for (int y = 0; y < png.Height; y++)
        {
            for (int x = 0; x < png.Width; x++)
            {
                for (int c = 0; c < 4; c++)
                {
                    int at = (4 * ((y * png.Width) + x)) + c;
                    int actual = png.Depth == 16 ? buffer.Rgba16![at] : buffer.Rgba8![at];
                    if (actual != Expected(png, x, y, c, hasTransparency))
                    {
                        Assert.Fail($"type {png.Type} depth {png.Depth} {png.Width}x{png.Height} pixel {x},{y},{c}: {actual}, not {Expected(png, x, y, c, hasTransparency)}");
                    }
                }
            }
        }
    }

    private static int Expected(TestPng png, int x, int y, int c, bool hasTransparency)
    {
        int max = png.Depth == 16 ? 65535 : 255;
        if (png.Type == 3)
        {
            int index = png.Sample(x, y, 0);
            int alpha = hasTransparency && index < 2 ? (index == 0 ? 7 : 200) : 255;
            return c == 3 ? alpha : (byte)(((3 * index) + c) * 37);
        }

        if (c == 3 && png.Channels % 2 == 0)
        {
            return png.Sample(x, y, png.Channels - 1);
        }

        if (c == 3)
        {
            bool same = Enumerable.Range(0, png.Channels).All(k => png.Sample(x, y, k) == png.Sample(1, 1, k));
            return hasTransparency && same ? 0 : max;
        }

        return (int)((long)png.Sample(x, y, png.Channels >= 3 ? c : 0) * max / ((1 << png.Depth) - 1));
    }

    internal static PixelBuffer Read(byte[] file) => PictureCodecs.Default.Read(new MemoryStream(file), "test.png");
}
