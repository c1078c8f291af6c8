namespace LabRaytracer.Tests.Rendering;

/// <summary>The picture does not depend on threads, vector width, tiles or crops, to the last bit.</summary>
public sealed class SamePictureTests
{
    private const int Width = 70, Height = 45;

    [Theory]
    [InlineData(Precision.Double)]
    [InlineData(Precision.Single)]
    public void Render_OneTwoThreeThreads_SameBits(Precision precision)
    {
        Scene scene = TestScenes.Everything();
        Picture Render(int threads) => Renderer.Render(
            scene, new RenderOptions { Width = Width, Height = Height, Threads = threads, Precision = precision, Samples = 4, Pattern = SamplePattern.Jittered }).Picture;
        Picture one = Render(1);
        PictureAssert.SameBits(one, Render(2));
        PictureAssert.SameBits(one, Render(3));
    }

    [Theory]
    [InlineData(Precision.Double, 4)]
    [InlineData(Precision.Double, 8)]
    [InlineData(Precision.Double, 16)]
    [InlineData(Precision.Single, 4)]
    [InlineData(Precision.Single, 8)]
    [InlineData(Precision.Single, 16)]
    public void Render_AnyVectorWidth_SameBits(Precision precision, int laneWidth)
    {
        Scene scene = TestScenes.Everything();
        RenderOptions options = new() { Width = Width, Height = Height, Threads = 1, Precision = precision };
        Picture narrow = Renderer.Render(scene, options, 1, null, default).Picture;
        PictureAssert.SameBits(narrow, Renderer.Render(scene, options, laneWidth, null, default).Picture);
    }

    [Theory]
    [InlineData(SamplePattern.Regular)]
    [InlineData(SamplePattern.Jittered)]
    public void Render_Crop_IsPartOfTheWholePicture(SamplePattern pattern)
    {
        Scene scene = TestScenes.Everything();
        Picture Render(PixelRectangle? crop) => Renderer.Render(
            scene, new RenderOptions { Width = Width, Height = Height, Threads = 2, Samples = 4, Pattern = pattern, Crop = crop }).Picture;
        Picture whole = Render(null);
        foreach (PixelRectangle crop in new PixelRectangle[] { new(0, 0, 1, 1), new(33, 7, 37, 20), new(69, 44, 1, 1), new(0, 0, Width, Height) })
        {
            Picture part = Render(crop);
            Assert.Equal((crop.Width, crop.Height), (part.Width, part.Height));
            for (int y = 0; y < crop.Height; y++)
            {
                Assert.True(part.Row(y).SequenceEqual(whole.Row(crop.Y + y).Slice(crop.X, crop.Width)), $"Row {y} of the crop {crop} differs.");
            }
        }
    }

    [Theory]
    [InlineData(-1, 0, 1, 1)]
    [InlineData(0, 0, 71, 1)]
    [InlineData(70, 0, 1, 1)]
    [InlineData(0, 45, 1, 1)]
    [InlineData(0, 0, 0, 1)]
    [InlineData(int.MaxValue, 0, int.MaxValue, 1)]
    public void Render_CropOutsideThePicture_SaysWhatIsAllowed(int x, int y, int width, int height)
    {
        RenderOptions options = new() { Width = Width, Height = Height, Crop = new PixelRectangle(x, y, width, height) };
        ArgumentOutOfRangeException failure = Assert.Throws<ArgumentOutOfRangeException>(() => Renderer.Render(new Scene(), options));
        Assert.Contains("The crop must lie inside the picture of 70 x 45 pixels.", failure.Message, StringComparison.Ordinal);
    }

    [Fact]
    public void Render_Twice_SameBits()
    {
        Scene scene = TestScenes.Everything();
        PictureAssert.SameBits(TestScenes.Render(scene, Width, Height, 2), TestScenes.Render(scene, Width, Height, 2));
    }

    [Fact]
    public void Render_CommaCulture_SameBits()
    {
        Picture point = TestScenes.Render(TestScenes.Everything(), Width, Height);
        using CommaCulture culture = new();
        PictureAssert.SameBits(point, TestScenes.Render(TestScenes.Everything(), Width, Height));
    }
}
