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

    /// <summary>One in each cell of n x n, one in each of n² columns, one in each of n² rows; pixels differ.</summary>
    [Theory]
    [InlineData(1)]
    [InlineData(2)]
    [InlineData(3)]
    [InlineData(4)]
    [InlineData(7)]
    [InlineData(16)]
    public void MultiJittered_EveryCellColumnAndRow_HoldsOne(int side)
    {
        RenderOptions options = new() { Samples = side * side, Seed = 5 };
        int count = side * side;
        HashSet<string> orders = [];
        for (int pixel = 0; pixel < 40; pixel++)
        {
            double[] x = [.. Enumerable.Range(0, count).Select(sample => SampleOffsets.MultiJittered(options, pixel, 3, sample, 0))];
            double[] y = [.. Enumerable.Range(0, count).Select(sample => SampleOffsets.MultiJittered(options, pixel, 3, sample, 1))];
            Assert.Equal(Enumerable.Range(0, count), x.Select(at => (int)(count * at)).Order());
            Assert.Equal(Enumerable.Range(0, count), y.Select(at => (int)(count * at)).Order());
            Assert.Equal(Enumerable.Range(0, count), x.Zip(y, (atX, atY) => (side * (int)(side * atY)) + (int)(side * atX)).Order());
            orders.Add(string.Join(' ', x.Select(at => (int)(count * at))));
        }

        Assert.InRange(orders.Count, side == 1 ? 1 : side == 2 ? 3 : 30, 40);
    }

    [Fact]
    public void MultiJittered_DependsOnSeedPixelAndSampleOnly()
    {
        RenderOptions options = new() { Samples = 4, Seed = 5 }, otherwise = new() { Samples = 4, Seed = 5, Width = 77, Threads = 7, Precision = Precision.Single };
        Assert.Equal(SampleOffsets.MultiJittered(options, 10, 20, 1, 0), SampleOffsets.MultiJittered(otherwise, 10, 20, 1, 0));
        Assert.NotEqual(SampleOffsets.MultiJittered(options, 10, 20, 1, 0), SampleOffsets.MultiJittered(new RenderOptions { Samples = 4, Seed = 6 }, 10, 20, 1, 0));
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
