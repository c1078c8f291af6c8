namespace LabRaytracer.Tests.Rendering;

public sealed class SampleOffsetsTests
{
    [Fact]
    public void Jittered_EverySample_LiesInItsCell()
    {
        RenderOptions options = new() { Samples = 9, Seed = 5 };
        for (int sample = 0; sample < 9; sample++)
        {
            for (int pixel = 0; pixel < 500; pixel++)
            {
                double x = SampleOffsets.Jittered(options, pixel, 3, sample, 0), y = SampleOffsets.Jittered(options, pixel, 3, sample, 1);
                Assert.Equal((sample % 3, sample / 3), ((int)(3 * x), (int)(3 * y)));
            }
        }
    }

    [Fact]
    public void Jittered_DependsOnSeedPixelAndSampleOnly()
    {
        RenderOptions options = new() { Samples = 4, Seed = 5 };
        RenderOptions otherwise = new() { Samples = 4, Seed = 5, Width = 77, Height = 5, Threads = 7, Precision = Precision.Single, Crop = new PixelRectangle(1, 1, 2, 2) };
        double value = SampleOffsets.Jittered(options, 10, 20, 0, 0);
        Assert.Equal(value, SampleOffsets.Jittered(otherwise, 10, 20, 0, 0));
        Assert.NotEqual(value, SampleOffsets.Jittered(new RenderOptions { Samples = 4, Seed = 6 }, 10, 20, 0, 0));
        Assert.NotEqual(value, SampleOffsets.Jittered(options, 20, 10, 0, 0));
        Assert.NotEqual(value, SampleOffsets.Jittered(options, 11, 20, 0, 0));
        Assert.NotEqual(value, SampleOffsets.Jittered(options, 10, 20, 2, 0));
        Assert.NotEqual(value, SampleOffsets.Jittered(options, 10, 20, 0, 1));
    }

    [Fact]
    public void Jittered_ManyPixels_AreEven()
    {
        // The mean of n uniform numbers lies within 5 sigma = 5 / sqrt(12 n) of 1/2, neighbours are not correlated.
        const int Count = 20000;
        RenderOptions options = new();
        double sum = 0, product = 0, before = 0;
        for (int pixel = 0; pixel < Count; pixel++)
        {
            double value = SampleOffsets.Jittered(options, pixel % 200, pixel / 200, 0, 0) - 0.5;
            sum += value;
            product += value * before;
            before = value;
        }

        Assert.InRange(sum / Count, -5 / Math.Sqrt(12.0 * Count), 5 / Math.Sqrt(12.0 * Count));
        Assert.InRange(product / Count, -5 / (12 * Math.Sqrt(Count)), 5 / (12 * Math.Sqrt(Count)));
    }

    [Theory]
    [InlineData(1, 0, 0.5, 0.5)]
    [InlineData(4, 1, 0.75, 0.25)]
    [InlineData(4, 2, 0.25, 0.75)]
    public void Regular_Sample_IsTheCentreOfItsCell(int samples, int sample, double x, double y)
    {
        RenderOptions options = new() { Samples = samples };
        Assert.Equal((x, y), (SampleOffsets.Regular(options, sample, 0), SampleOffsets.Regular(options, sample, 1)));
    }
}
