namespace LabRaytracer.Tests.Imaging;

/// <summary>Rounding of smooth light to 8 bits by an ordered pattern.</summary>
public class DitheringTests
{
    [Fact]
    public void Threshold_EightByEight_IsBayersMatrix()
    {
        // First and second row of the 8 x 8 matrix as printed in textbooks (Foley, van Dam, Feiner, Hughes, section 13.1.2), times 64.
        int[] first = [0, 32, 8, 40, 2, 34, 10, 42], second = [48, 16, 56, 24, 50, 18, 58, 26];
        for (int x = 0; x < 8; x++)
        {
            Assert.Equal((first[x] + 0.5f) / 64, OrderedDither.Threshold(x, 0));
            Assert.Equal((second[x] + 0.5f) / 64, OrderedDither.Threshold(x, 1));
        }
    }

    [Fact]
    public void Threshold_EightByEight_TakesEveryValueOnceAndRepeats()
    {
        IEnumerable<float> all = from y in Enumerable.Range(8, 8) from x in Enumerable.Range(16, 8) select OrderedDither.Threshold(x, y);
        Assert.Equal(Enumerable.Range(0, 64).Select(k => (k + 0.5f) / 64), all.Order());
    }

    [Fact]
    public void BlueNoise_SixtyFourSquared_TakesEveryValueOnceAndRepeats()
    {
        IEnumerable<float> all = from y in Enumerable.Range(64, 64) from x in Enumerable.Range(128, 64) select BlueNoiseMask.Threshold(x, y);
        Assert.Equal(Enumerable.Range(0, 4096).Select(k => (k + 0.5f) / 4096), all.Order());
    }

    /// <summary>
    /// Pixels below a level, counted in all windows of 8 x 8: white noise varies with a standard deviation of 8 sqrt(p (1 - p)), which is 4 at one half; blue noise, whose
    /// power lies at high frequencies, by less than half of that.
    /// </summary>
    [Theory]
    [InlineData(0.0625)]
    [InlineData(0.25)]
    [InlineData(0.5)]
    [InlineData(0.75)]
    [InlineData(0.9375)]
    public void BlueNoise_CountsInWindows_HardlyVary(double level)
    {
        double squares = 0;
        for (int window = 0; window < 4096; window++)
        {
            IEnumerable<bool> isBelow =
                from y in Enumerable.Range(window / 64, 8) from x in Enumerable.Range(window % 64, 8) select BlueNoiseMask.Threshold(x, y) < level;
            double difference = isBelow.Count(below => below) - (64 * level);
            squares += difference * difference;
        }

        Assert.InRange(Math.Sqrt(squares / 4096), 0, 8 * Math.Sqrt(level * (1 - level)) / 2);
    }

    /// <summary>No direction stands out: the mean product of deviations of pixels next to each other is alike along rows and columns, and negative.</summary>
    [Fact]
    public void BlueNoise_Neighbours_DifferInEveryDirection()
    {
        double Product(int dx, int dy) =>
            12 * Enumerable.Range(0, 4096).Average(i => Deviation(i % 64, i / 64) * Deviation((i % 64) + dx, (i / 64) + dy));
        double Deviation(int x, int y) => BlueNoiseMask.Threshold(x, y) - 0.5;
        Assert.InRange(Product(1, 0), -1, -0.1);
        Assert.InRange(Product(0, 1), -1, -0.1);
        Assert.InRange(Product(1, 0) - Product(0, 1), -0.05, 0.05);
    }

    [Theory]
    [InlineData(Dithering.Ordered)]
    [InlineData(Dithering.BlueNoise)]
    public void Save_LightOfACode_KeepsTheCode(Dithering dithering)
    {
        byte[] codes = Codes(Enumerable.Range(0, 256).Select(code => ColorEncoding.LinearFromSrgb8((byte)code)).ToArray(), TransferFunction.Srgb, dithering);
        for (int i = 0; i < codes.Length; i++)
        {
            Assert.Equal(i / 64, codes[i]);
        }
    }

    [Theory]
    [InlineData(0.0001f)]
    [InlineData(0.2f)]
    [InlineData(0.9999f)]
    public void Save_BlueNoise_KeepsTheMean(float light)
    {
        byte[] codes = Codes([light], TransferFunction.Srgb, Dithering.BlueNoise, 64);
        int low = codes.Min();
        double step = ColorEncoding.LinearFromSrgb8((byte)Math.Min(255, low + 1)) - ColorEncoding.LinearFromSrgb8((byte)low);
        double mean = codes.Average(code => (double)ColorEncoding.LinearFromSrgb8(code));
        Assert.InRange(Math.Abs(mean - light), 0, (step / 8192) + 1e-7);
    }

    [Theory]
    [InlineData(0.0001f)]
    [InlineData(0.2f)]
    [InlineData(0.21404114f)]
    [InlineData(0.7f)]
    [InlineData(0.9999f)]
    public void Save_EvenLight_KeepsTheMeanAndUsesTwoNeighbours(float light)
    {
        byte[] codes = Codes([light], TransferFunction.Srgb);
        int low = codes.Min(), high = codes.Max();
        Assert.InRange(high - low, 0, 1);
        double step = ColorEncoding.LinearFromSrgb8((byte)Math.Min(255, low + 1)) - ColorEncoding.LinearFromSrgb8((byte)low);
        double mean = codes.Average(code => (double)ColorEncoding.LinearFromSrgb8(code));
        Assert.InRange(Math.Abs(mean - light), 0, (step / 128) + 1e-7);
    }

    [Fact]
    public void Save_LinearCodesAndNumbersOutOfRange_AreCut()
    {
        Assert.All(Codes([float.NaN], TransferFunction.Linear), code => Assert.Equal(0, code));
        Assert.All(Codes([-1], TransferFunction.Linear), code => Assert.Equal(0, code));
        Assert.All(Codes([2], TransferFunction.Linear), code => Assert.Equal(255, code));
        byte[] half = Codes([0.5f], TransferFunction.Linear);
        Assert.Equal((32, 32), (half.Count(code => code == 127), half.Count(code => code == 128)));
    }

    /// <summary>Codes of a square of pixels of each light, side by side in the picture; those of one light after the other.</summary>
    private static byte[] Codes(float[] lights, TransferFunction transfer, Dithering dithering = Dithering.Ordered, int side = 8)
    {
        RowEncoder encoder = new(transfer, 8, ToneMapping.Default, dithering);
        List<byte> codes = [];
        foreach (float light in lights)
        {
            Intensity[] row = [.. Enumerable.Repeat(Intensity.Grey(light), side)];
            byte[] target = new byte[3 * side];
            for (int y = 0; y < side; y++)
            {
                encoder.Encode(row, y, target);
                codes.AddRange(Enumerable.Range(0, side).Select(x => target[3 * x]));
            }
        }

        return [.. codes];
    }
}
