namespace LabRaytracer.Tests;

public sealed class PictureDifferenceTests
{
    [Fact]
    public void Compare_EqualPictures_HaveNoDifference()
    {
        Picture picture = PngWriteTests.Pattern(40, 30);
        PictureDifference difference = PictureDifference.Compare(picture, picture);
        Assert.Equal((0, 0), (difference.Rmse, difference.Max));
        Assert.Equal(double.PositiveInfinity, difference.Psnr);
        Assert.Equal(1, difference.Ssim, 12);
        Assert.All(difference.CreateHeatMap().Pixels.ToArray(), pixel => Assert.Equal(Intensity.Black, pixel));
    }

    [Theory]
    [InlineData(3, 3)]
    [InlineData(11, 11)]
    [InlineData(50, 20)]
    public void Compare_BlackAndWhite_HasTheLargestDifference(int width, int height)
    {
        Picture white = new(width, height);
        white.Pixels.Fill(Intensity.White);
        PictureDifference difference = PictureDifference.Compare(new Picture(width, height), white);
        Assert.Equal(1, difference.Rmse, 12);
        Assert.Equal(0, difference.Psnr, 10);
        Assert.Equal(1, difference.Max, 12);

        // Means 0 and 1, no variance: C1 / (1 + C1) with C1 = 0.0001 (Wang et al., 2004, equation 13).
        Assert.Equal(0.0001 / 1.0001, difference.Ssim, 9);
        Assert.Equal(Intensity.White, difference.CreateHeatMap()[1, 1]);
    }

    [Fact]
    public void Compare_OnePixelByOneCode_GivesTheFormulas()
    {
        Picture a = new(20, 10);
        Picture b = new(20, 10);
        b[7, 3] = new Intensity(0, ColorEncoding.LinearFromSrgb8(51), 0);
        PictureDifference difference = PictureDifference.Compare(a, b);

        // One component of 600 differs by 51/255 = 1/5: RMSE = 0.2 / sqrt(600).
        Assert.Equal(0.2 / Math.Sqrt(600), difference.Rmse, 8);
        Assert.Equal(0.2, difference.Max, 6);
        Assert.Equal(20 * Math.Log10(Math.Sqrt(600) / 0.2), difference.Psnr, 5);
        Picture map = difference.CreateHeatMap(fullScale: 0.2 / Math.Sqrt(3) * 2);
        Assert.Equal(1, map[7, 3].R, 4);
        Assert.Equal(0, map[7, 3].B, 4);
        Assert.Equal(Intensity.Black, map[6, 3]);
    }

    [Fact]
    public void Compare_OrderOfPictures_DoesNotMatter()
    {
        Picture a = PngWriteTests.Pattern(40, 30);
        Picture b = PngWriteTests.Pattern(40, 30);
        b.Row(3).Reverse();
        Assert.Equal(PictureDifference.Compare(a, b).Ssim, PictureDifference.Compare(b, a).Ssim, 12);
        Assert.InRange(PictureDifference.Compare(a, b).Ssim, -1, 0.9999);
    }

    [Fact]
    public void Compare_DifferentSizes_Throws() =>
        Assert.Throws<ArgumentException>(() => PictureDifference.Compare(new Picture(2, 2), new Picture(2, 3)));
}
