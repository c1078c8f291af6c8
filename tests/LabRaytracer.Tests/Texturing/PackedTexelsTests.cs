namespace LabRaytracer.Tests.Texturing;

/// <summary>Large pictures whose texels are packed for bilinear lookups: the same colours as from rows.</summary>
public sealed class PackedTexelsTests
{
    [Theory]
    [InlineData(512, 256)]
    [InlineData(703, 387)]
    [InlineData(2048, 64)]
    [InlineData(380, 256)]
    public void Unpack_Picture_SameSamples(int width, int height)
    {
        byte[] samples = Samples(width, height);
        var packed = PackedTexels.Of(Pixels(width, height, (byte[])samples.Clone()).GivenAway());
        Assert.NotNull(packed);
        Assert.Equal(samples, packed.Unpack());
    }

    [Theory]
    [InlineData(255, 256, 255)]
    [InlineData(512, 256, 254)]
    [InlineData(40, 20000, 255)]
    public void Of_SmallNarrowOrTransparent_Null(int width, int height, byte alpha)
    {
        byte[] samples = Samples(width, height);
        samples[^1] = alpha;
        Assert.Null(PackedTexels.Of(Pixels(width, height, samples).GivenAway()));
    }

    [Fact]
    public void Of_SamplesThatSomebodyHolds_NullAndUntouched()
    {
        byte[] samples = Samples(512, 256);
        Assert.Null(PackedTexels.Of(Pixels(512, 256, samples)));
        Assert.Equal(Samples(512, 256), samples);
    }

    [Theory]
    [InlineData(TextureWrap.Repeat, TextureWrap.Pole, true)]
    [InlineData(TextureWrap.Clamp, TextureWrap.Repeat, true)]
    [InlineData(TextureWrap.Repeat, TextureWrap.Clamp, false)]
    [InlineData(TextureWrap.Mirror, TextureWrap.Border, false)]
    public void Sample_EveryWidth_SameBitsAsFromRows(TextureWrap wrapU, TextureWrap wrapV, bool isLinear)
    {
        const int Width = 703, Height = 387;
        SamplingOptions options = new() { ColorSpace = isLinear ? ColorSpace.Linear : ColorSpace.Srgb };
        TexelStore rows = new(Pixels(Width, Height, Samples(Width, Height)), forPairs: true), packed = new(Pixels(Width, Height, Samples(Width, Height)).GivenAway(), forPairs: true);
        Assert.Null(rows.Packed);
        Assert.NotNull(packed.Packed);
        Random random = new(7);
        double Coordinate(int size) => random.Next(4) == 0 ? (random.Next(-2, size + 3) + (random.Next(3) / 2.0)) / size : (3 * random.NextDouble()) - 1;
        TextureLookup[] lookups =
        [
            .. SamplerRun.Lookups(wrapU, wrapV),
            .. Enumerable.Range(0, 4000).Select(_ => new TextureLookup(new TextureCoordinate(Coordinate(Width), Coordinate(Height)), WrapU: wrapU, WrapV: wrapV)),
        ];
        TextureSampler ofRows = PictureSamplers.Create(rows, TextureUse.Color, options, TextureFilter.Bilinear), ofPacked = PictureSamplers.Create(packed, TextureUse.Color, options, TextureFilter.Bilinear);
        Intensity[] expected = SamplerRun.Sample<Double1, Float1, Int1>(ofRows, lookups);
        Assert.Equal(expected, SamplerRun.Sample<Double1, Float1, Int1>(ofPacked, lookups));
        Assert.Equal(expected, SamplerRun.Sample<Double4, Float4, Int4>(ofPacked, lookups));
        Assert.Equal(expected, SamplerRun.Sample<Double8, Float8, Int8>(ofPacked, lookups));
        Assert.Equal(expected, SamplerRun.Sample<Double16, Float16, Int16>(ofPacked, lookups));
        Assert.Equal(SamplerRun.Sample<Float16, Float16, Int16>(ofRows, lookups), SamplerRun.Sample<Float16, Float16, Int16>(ofPacked, lookups));
    }

    [Fact]
    public void ColorAndSamples_Packed_AsInTheFile()
    {
        TexelStore rows = new(Pixels(512, 256, Samples(512, 256))), packed = new(Pixels(512, 256, Samples(512, 256)).GivenAway(), forPairs: true);
        ReadOnlySpan<float> table = PictureSamplers.DecodeTable(rows, isData: false, ColorSpace.Srgb);
        for (int i = 0; i < 512 * 256; i += 7)
        {
            Assert.Equal(rows.Color(table, i % 512, i / 512), packed.Color(table, i % 512, i / 512));
            Assert.Equal(1, packed.Alpha(i % 512, i / 512));
        }

        unsafe
        {
            Assert.True(new ReadOnlySpan<byte>(rows.Samples, 4 * 512 * 256).SequenceEqual(new ReadOnlySpan<byte>(packed.Samples, 4 * 512 * 256)));
        }

        Assert.Equal(rows.Color(table, 5, 6), packed.Color(table, 5, 6));
    }

    private static PixelBuffer Pixels(int width, int height, byte[] samples) => PixelBuffer.FromRgba8(width, height, samples, TransferFunction.Srgb, "test");

    private static byte[] Samples(int width, int height)
    {
        byte[] samples = new byte[4 * width * height];
        new Random(3).NextBytes(samples);
        for (int i = 3; i < samples.Length; i += 4)
        {
            samples[i] = 255;
        }

        return samples;
    }
}
