namespace LabRaytracer.Tests.Texturing;

/// <summary>Packed texels of files, and the lab's array as a door onto them.</summary>
public sealed class StoreTests
{
    /// <summary>Textures of all kinds of stores: an array, and files of 8-bit sRGB, 8-bit linear, 16-bit and float samples.</summary>
    internal static IEnumerable<Texture> EveryFormat(int width, int height)
    {
        var random = new Random(9);
        Picture picture = new(width, height);
        foreach (ref Intensity pixel in picture.Pixels)
        {
            pixel = new Intensity(random.NextSingle(), random.NextSingle(), random.NextSingle());
        }

        yield return Texture.FromPicture(picture);
        foreach ((string name, PictureSaveOptions options) in Formats())
        {
            using TestFolder folder = new();
            picture.Save(folder[name], options);
            var loaded = Texture.Load(folder[name]);
            Assert.Equal(width, loaded.Width);
            yield return loaded;
        }
    }

    [Theory]
    [InlineData(0, 0)]
    [InlineData(10, 0.00303526983548837491653)]
    [InlineData(128, 0.215860500113899163762)]
    [InlineData(188, 0.502886458032568385171)]
    [InlineData(255, 1)]
    public void Load_EightBits_DecodesSrgb(int code, double light)
    {
        // IEC 61966-2-1: ((c + 0.055) / 1.055)^2.4 above 0.04045, c / 12.92 below; values by mpmath at 60 digits.
        Texture texture = FromCodes((byte)code);
        Assert.Equal((float)light, texture.Sample(TextureLookup.At(0.5, 0.5)).R);
        Assert.Equal((float)(code / 255.0), texture.With(new SamplingOptions { ColorSpace = ColorSpace.Linear }).Sample(TextureLookup.At(0.5, 0.5)).R);
        Assert.Equal((float)light, texture.ColorMap[0, 0].R);
    }

    [Theory]
    [InlineData(0)]
    [InlineData(77)]
    [InlineData(128)]
    [InlineData(255)]
    public void DataSlot_EightBits_AreNumbersAsTheyAre(int code)
    {
        Texture texture = FromCodes((byte)code);
        TextureLookup[] lookups = [TextureLookup.At(0.5, 0.5)];
        float Number() => SamplerRun.Sample<Double8, Float8, Int8>(((IPreparedTexture)texture).Prepare(TextureUse.Data, filter: null), lookups)[0].R;
        Assert.Equal((float)(code / 255.0), Number());
        Assert.NotEmpty(texture.ColorMap);
        Assert.Equal((float)(code / 255.0), Number());
        TextureSampler asColor = ((IPreparedTexture)texture.With(new SamplingOptions { ColorSpace = ColorSpace.Srgb })).Prepare(TextureUse.Data, filter: null);
        Assert.Equal(texture.Sample(lookups[0]), SamplerRun.Sample<Double8, Float8, Int8>(asColor, lookups)[0]);
    }

    [Fact]
    public void E5_ColorMapRowZero_IsTheBottomRowOfThePicture()
    {
        Picture picture = new(2, 3);
        picture[0, 0] = Intensity.White;
        picture[1, 2] = Intensity.Grey(0.5f);
        var texture = Texture.FromPicture(picture);
        Assert.Equal((Intensity.White, Intensity.Grey(0.5f)), (texture.ColorMap[0, 2], texture.ColorMap[1, 0]));
        using TestFolder folder = new();
        picture.Save(folder["p.pfm"]);
        var loaded = Texture.Load(folder["p.pfm"]);
        Assert.Equal(Intensity.White, loaded.Sample(TextureLookup.At(0.25, 5 / 6.0)));
        Assert.Equal((Intensity.White, Intensity.Grey(0.5f)), (loaded.ColorMap[0, 2], loaded.ColorMap[1, 0]));
    }

    [Fact]
    public void ColorMap_ReadOnly_ChangesNoPixel()
    {
        foreach (Texture texture in EveryFormat(9, 6))
        {
            Scene scene = Rendering.TestScenes.QuadFromAbove(Rendering.TestScenes.Shining(texture));
            Picture before = Rendering.TestScenes.Render(scene, 40, 40);
            Assert.Equal(9 * 6, texture.ColorMap.Length);
            PictureAssert.SameBits(before, Rendering.TestScenes.Render(scene, 40, 40));
        }
    }

    [Fact]
    public void ColorMap_EditedBetweenRenders_Counts()
    {
        foreach (Texture texture in EveryFormat(4, 4))
        {
            texture.Sampling = new SamplingOptions { Filter = TextureFilter.Nearest };
            Scene scene = Rendering.TestScenes.QuadFromAbove(Rendering.TestScenes.Shining(texture));
            Rendering.TestScenes.Render(scene, 4, 4);
            texture.ColorMap[1, 3] = new Intensity(7, 8, 9);
            Assert.Equal(new Intensity(7, 8, 9), Rendering.TestScenes.Render(scene, 4, 4)[1, 0]);
        }
    }

    [Fact]
    public void Constructor_SidesOutsideTheirRange_AreRefused()
    {
        Assert.Throws<ArgumentOutOfRangeException>(() => new Texture(0, 1));
        Assert.Throws<ArgumentOutOfRangeException>(() => new Texture(1, (1 << 20) + 1));
        Assert.Throws<ArgumentOutOfRangeException>(() => new Texture(new Intensity[0, 3]));
        FileNotFoundException failure = Assert.Throws<FileNotFoundException>(() => Texture.Load("no-such.png"));
        Assert.Contains("no-such.png", failure.Message, StringComparison.Ordinal);
    }

    private static Texture FromCodes(byte code)
    {
        using TestFolder folder = new();
        File.WriteAllBytes(folder["c.ppm"], [.. "P6 1 1 255\n"u8, code, code, code]);
        var texture = Texture.Load(folder["c.ppm"]);
        Assert.Equal(1, texture.Width);
        return texture;
    }

    private static (string Name, PictureSaveOptions Options)[] Formats() =>
    [
        ("srgb8.png", PictureSaveOptions.Default),
        ("linear8.png", new PictureSaveOptions { Encoding = TransferFunction.Linear }),
        ("srgb16.png", new PictureSaveOptions { BitDepth = 16 }),
        ("float.pfm", PictureSaveOptions.Default),
    ];
}
