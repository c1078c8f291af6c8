using System.Text;

namespace LabRaytracer.Tests;

public sealed class HdrTests
{
    private const string Head = "#?RADIANCE\n# comment\nFORMAT=32-bit_rle_rgbe\n\n";

    [Fact]
    public void Read_FlatPixels_GivesMantissaTimesPowerOfTwo()
    {
        // 128 * 2^(129 - 136) = 1, 64 -> 0.5, exponent 0 -> 0.
        PixelBuffer buffer = Read(Head + "-Y 1 +X 2\n", [128, 64, 255, 129, 9, 9, 9, 0]);
        Assert.Equal([1f, 0.5f, 255 / 128f, 1f, 0f, 0f, 0f, 1f], buffer.RgbaFloat!);
        Assert.True(buffer.Transfer.IsLinear);
    }

    [Fact]
    public void Read_OldRuns_RepeatThePixelBefore()
    {
        // 1 pixel, a run of 2, then a run of 1 in the next byte (256 more).
        byte[] data = [128, 0, 0, 129, 1, 1, 1, 2, 1, 1, 1, 1];
        PixelBuffer buffer = Read(Head + "-Y 1 +X 259\n", data);
        Assert.All(Enumerable.Range(0, 259), x => Assert.Equal(1f, buffer.RgbaFloat![4 * x]));
    }

    [Fact]
    public void Read_NewRuns_GivesEveryChannel()
    {
        // Eight pixels: red run of 8 x 128, green literal 1..8, blue run of 3 and 5, exponent run.
        byte[] data = [2, 2, 0, 8, 136, 128, 8, 1, 2, 3, 4, 5, 6, 7, 8, 131, 5, 133, 6, 136, 136];
        PixelBuffer buffer = Read(Head + "-Y 1 +X 8\n", data);
        for (int x = 0; x < 8; x++)
        {
            Assert.Equal([128f, x + 1, x < 3 ? 5 : 6, 1], buffer.RgbaFloat!.AsSpan(4 * x, 4).ToArray());
        }
    }

    [Fact]
    public void Read_Exposure_IsDividedOut()
    {
        PixelBuffer buffer = Read("#?RADIANCE\nEXPOSURE=2\nFORMAT=32-bit_rle_rgbe\nEXPOSURE= 4.0\n\n-Y 1 +X 1\n", [128, 128, 128, 129]);
        Assert.Equal(0.125f, buffer.RgbaFloat![0]);
    }

    [Theory]
    [InlineData("-Y 2 +X 3", "123456")]
    [InlineData("+Y 2 +X 3", "456123")]
    [InlineData("-Y 2 -X 3", "321654")]
    [InlineData("+Y 2 -X 3", "654321")]
    [InlineData("+X 3 -Y 2", "135246")]
    [InlineData("+X 3 +Y 2", "246135")]
    [InlineData("-X 3 -Y 2", "531642")]
    [InlineData("-X 3 +Y 2", "642531")]
    public void Read_EveryOrientation_PutsPixelsInPlace(string resolution, string expected)
    {
        // Six flat pixels 1..6 in the order of the file.
        byte[] data = [.. Enumerable.Range(1, 6).SelectMany(i => new byte[] { (byte)i, 0, 0, 136 })];
        PixelBuffer buffer = Read(Head + resolution + "\n", data);
        Assert.Equal((3, 2), (buffer.Width, buffer.Height));
        Assert.Equal(expected, string.Concat(Enumerable.Range(0, 6).Select(i => (char)('0' + (int)buffer.RgbaFloat![4 * i]))));
    }

    [Theory]
    [InlineData("#?RADIANCE\nFORMAT=32-bit_rle_xyze\n\n-Y 1 +X 1\n", "not supported")]
    [InlineData("#?RADIANCE\nEXPOSURE=0\n\n-Y 1 +X 1\n", "EXPOSURE")]
    [InlineData("#?RADIANCE\nEXPOSURE=1,5\n\n-Y 1 +X 1\n", "EXPOSURE")]
    [InlineData(Head + "-Y 1 +Y 1\n", "resolution")]
    [InlineData(Head + "-Y 99999 +X 99999\n", "limit")]
    [InlineData(Head + "-Y 1 +X 2\n", "too early")]
    [InlineData(Head + "-Y 1 +X 2\n\u0001\u0001\u0001\u0001", "run")]
    [InlineData(Head + "-Y 1 +X 2\n\u0080\u0000\u0000\u0080\u0001\u0001\u0001\u0002", "run")]
    [InlineData(Head + "-Y 1 +X 8\n\u0002\u0002\u0000\u0009", "another length")]
    [InlineData(Head + "-Y 1 +X 8\n\u0002\u0002\u0000\u0008\u0089\u0001", "run")]
    [InlineData(Head + "-Y 1 +X 8\n\u0002\u0002\u0000\u0008\u0000\u0001", "run")]
    public void Read_WrongFile_IsRefused(string file, string reason)
    {
        PictureFormatException error = Assert.Throws<PictureFormatException>(() => Read(file, []));
        Assert.Contains(reason, error.Message, StringComparison.Ordinal);
    }

    [Theory]
    [InlineData(5)]
    [InlineData(8)]
    [InlineData(300)]
    [InlineData(33000)]
    public void Write_AnyWidth_ReadsBackWithinHalfAStep(int width)
    {
        using TestFolder folder = new();
        Picture picture = PngWriteTests.Pattern(width, 3);
        for (int x = 0; x < width; x++)
        {
            // Values over the whole range of the format, and rows with long runs.
            picture[x, 1] *= (float)Math.ScaleB(1, (x * 31 % 240) - 120);
            picture[x, 2] = Intensity.Grey(x / 200);
        }

        picture.Save(folder["a.hdr"]);
        Picture back = Picture.Load(folder["a.hdr"]);
        for (int i = 0; i < picture.Pixels.Length; i++)
        {
            // Half a step of the shared exponent: 2^-8 of the largest component at most, or of the smallest exponent.
            Intensity error = picture.Pixels[i] - back.Pixels[i];
            float bound = Math.Max(picture.Pixels[i].Max / 256, MathF.ScaleB(1, -136));
            Assert.InRange(Math.Max(Math.Abs(error.R), Math.Max(Math.Abs(error.G), Math.Abs(error.B))), 0, bound);
        }
    }

    [Fact]
    public void Write_ValuesOutsideOfTheFormat_BecomeZeroOrTheLargest()
    {
        using TestFolder folder = new();
        Picture picture = new(1, 1);
        picture[0, 0] = new Intensity(float.NaN, -1, float.PositiveInfinity);
        picture.Save(folder["a.hdr"]);
        Intensity back = Picture.Load(folder["a.hdr"])[0, 0];
        Assert.Equal((0f, 0f), (back.R, back.G));
        Assert.Equal(255 * MathF.ScaleB(1, 119), back.B);
    }

    private static PixelBuffer Read(string head, byte[] data) =>
        PictureCodecs.Default.Read(new MemoryStream([.. Encoding.Latin1.GetBytes(head), .. data]), "test.hdr");
}
