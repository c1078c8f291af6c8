using System.Text;

namespace LabRaytracer.Tests;

public sealed class NetpbmTests
{
    [Theory]
    [InlineData("P2\n2 1\n255\n10 200\n")]
    [InlineData("P2 # a comment\n#another 7\n 2\t1 255 10\n\n200")]
    [InlineData("P5\n2 1\n255\n\n\u00C8")]
    [InlineData("P5#c\n2#d\n1\r\n255\n\n\u00C8")]
    public void Read_GreyForms_GivesGreySamples(string file)
    {
        PixelBuffer buffer = Read(Encoding.Latin1.GetBytes(file));
        Assert.Equal([10, 10, 10, 255, 200, 200, 200, 255], buffer.Rgba8!);
        Assert.True(buffer.IsGrey && buffer.Transfer.IsSrgb);
    }

    [Theory]
    [InlineData("P3\n1 2\n255\n1 2 3\n4 5 255")]
    [InlineData("P6\n1 2\n255\n\u0001\u0002\u0003\u0004\u0005\u00FF")]
    public void Read_ColourForms_GivesRowsFromTheTop(string file) =>
        Assert.Equal([1, 2, 3, 255, 4, 5, 255, 255], Read(Encoding.Latin1.GetBytes(file)).Rgba8!);

    [Fact]
    public void Read_OtherLargestValues_AreScaled()
    {
        Assert.Equal([0, 0, 0, 255, 255, 255, 255, 255], Read("P2 2 1 1 0 1"u8.ToArray()).Rgba8!);
        Assert.Equal([17, 17, 17, 255], Read("P2 1 1 15 1"u8.ToArray()).Rgba8!);

        // 500 / 1000 of 65535 is 32767.5, rounded up.
        Assert.Equal([32768, 32768, 32768, 65535], Read("P2 1 1 1000 500"u8.ToArray()).Rgba16!);
        Assert.Equal([0x1234, 0xFFFF, 0, 65535], Read([.. "P6 1 1 65535\n"u8, 0x12, 0x34, 0xFF, 0xFF, 0, 0]).Rgba16!);
    }

    [Theory]
    [InlineData("P5 1 1 255\n", "too early")]
    [InlineData("P2 1 1 255 256", "above the largest")]
    [InlineData("P2 1 1 255 -1", "whole number")]
    [InlineData("P2 1 1 0 0", "[1, 65535]")]
    [InlineData("P2 1 1 65536 0", "[1, 65535]")]
    [InlineData("P2 0 1 255 0", "not possible")]
    [InlineData("P5 99999 99999 255\n", "limit")]
    [InlineData("P5 8000 8000 255\n", "too early")]
    [InlineData("P2 1 1 99999999999999999999999 0", "other than a number")]
    [InlineData("PF 1 1 0\n0000", "scale")]
    [InlineData("PF 1 1 1,5\n000000000000", "scale")]
    [InlineData("PF 1 1 -1\n00000000000", "too early")]
    [InlineData("P4 8 1 0", "not known")]
    [InlineData("", "empty")]
    public void Read_WrongFile_IsRefused(string file, string reason)
    {
        PictureFormatException error = Assert.Throws<PictureFormatException>(() => Read(Encoding.Latin1.GetBytes(file)));
        Assert.Contains(reason, error.Message, StringComparison.Ordinal);
    }

    [Fact]
    public void Read_FloatForms_BothByteOrdersFromTheBottom()
    {
        // 1.0f is 3F 80 00 00, -2.5f is C0 20 00 00.
        byte[] big = [.. "Pf\n1 2\n1.0\n"u8, 0x3F, 0x80, 0, 0, 0xC0, 0x20, 0, 0];
        byte[] little = [.. "Pf\n1 2\n-1.0\n"u8, 0, 0, 0x80, 0x3F, 0, 0, 0x20, 0xC0];
        foreach (byte[] file in new[] { big, little })
        {
            PixelBuffer buffer = Read(file);
            Assert.Equal([-2.5f, -2.5f, -2.5f, 1, 1, 1, 1, 1], buffer.RgbaFloat!);
            Assert.True(buffer.Transfer.IsLinear);
        }
    }

    [Fact]
    public void Pfm_WriteAndRead_KeepsEveryBit()
    {
        using TestFolder folder = new();
        Picture picture = new(3, 2);
        picture[0, 0] = new Intensity(float.MaxValue, -1e-30f, 0.1f);
        picture[2, 1] = new Intensity(float.NaN, float.PositiveInfinity, -0f);
        picture.Save(folder["a.pfm"]);
        Picture back = Picture.Load(folder["a.pfm"]);
        for (int i = 0; i < 6; i++)
        {
            Assert.Equal(picture.Pixels[i], back.Pixels[i]);
        }
    }

    [Theory]
    [InlineData(8)]
    [InlineData(16)]
    public void Ppm_WriteAndRead_KeepsCodes(int depth)
    {
        using TestFolder folder = new();
        Picture picture = PngWriteTests.Pattern(30, 20);
        picture.Save(folder["a.ppm"], new PictureSaveOptions { BitDepth = depth });
        picture.Save(folder["a.png"], new PictureSaveOptions { BitDepth = depth });
        Assert.Equal(Picture.Load(folder["a.png"]).Pixels, Picture.Load(folder["a.ppm"]).Pixels);
    }

    private static PixelBuffer Read(byte[] file) => PictureCodecs.Default.Read(new MemoryStream(file), "test.ppm");
}
