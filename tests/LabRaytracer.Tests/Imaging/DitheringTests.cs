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
    public void Save_LightOfACode_KeepsTheCode()
    {
        byte[] codes = Codes(Enumerable.Range(0, 256).Select(code => ColorEncoding.LinearFromSrgb8((byte)code)).ToArray(), TransferFunction.Srgb);
        for (int i = 0; i < codes.Length; i++)
        {
            Assert.Equal(i / 64, codes[i]);
        }
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

    /// <summary>Codes of 8 x 8 pixels of each light, side by side in the picture; those of one light after the other.</summary>
    private static byte[] Codes(float[] lights, TransferFunction transfer)
    {
        RowEncoder encoder = new(transfer, 8, ToneMapping.Default, Dithering.Ordered);
        List<byte> codes = [];
        foreach (float light in lights)
        {
            Intensity[] row = [.. Enumerable.Repeat(Intensity.Grey(light), 8)];
            byte[] target = new byte[24];
            for (int y = 0; y < 8; y++)
            {
                encoder.Encode(row, y, target);
                codes.AddRange(Enumerable.Range(0, 8).Select(x => target[3 * x]));
            }
        }

        return [.. codes];
    }
}
