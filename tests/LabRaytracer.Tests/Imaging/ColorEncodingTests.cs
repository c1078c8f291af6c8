namespace LabRaytracer.Tests;

/// <summary>Literals: Oracle/srgb.py (mpmath, 60 digits); the 64-bit numbers are FNV-1a over the bits of whole tables.</summary>
public sealed class ColorEncodingTests
{
    private const ulong FnvStart = 0xCBF29CE484222325;
    private const ulong FnvPrime = 0x100000001B3;

    [Theory]
    [InlineData(0, 0x00000000u)]
    [InlineData(1, 0x399F22B4u)]
    [InlineData(10, 0x3B46EB61u)]
    [InlineData(11, 0x3B5B518Eu)]
    [InlineData(128, 0x3E5D0A89u)]
    [InlineData(188, 0x3F00BD2Bu)]
    [InlineData(254, 0x3F7DB8DEu)]
    [InlineData(255, 0x3F800000u)]
    public void LinearFromSrgb8_Code_IsTheNearestFloat(byte code, uint bits)
    {
        Assert.Equal(bits, BitConverter.SingleToUInt32Bits(ColorEncoding.LinearFromSrgb8(code)));
        Assert.Equal(bits, BitConverter.SingleToUInt32Bits(ColorEncoding.LinearFromSrgb16((ushort)(code * 257))));
    }

    [Fact]
    public void DecodeTables_AllCodes_HaveTheOracleBits()
    {
        Assert.Equal(0x1CFF6F01D8B73776ul, Fnv(Enumerable.Range(0, 256).Select(k => ColorEncoding.LinearFromSrgb8((byte)k))));
        Assert.Equal(0xC5F8779B6F7B11CEul, Fnv(Enumerable.Range(0, 65536).Select(k => ColorEncoding.LinearFromSrgb16((ushort)k))));
    }

    [Fact]
    public void Srgb8FromLinear_AroundEveryThreshold_IsExactlyRounded()
    {
        List<float> thresholds = [];
        for (int code = 1; code < 256; code++)
        {
            float threshold = Smallest(light => ColorEncoding.Srgb8FromLinear(light) >= code);
            Assert.Equal(code, ColorEncoding.Srgb8FromLinear(threshold));
            Assert.Equal(code - 1, ColorEncoding.Srgb8FromLinear(MathF.BitDecrement(threshold)));
            thresholds.Add(threshold);
        }

        Assert.Equal(0x63422992D94AED21ul, Fnv(thresholds));
    }

    [Fact]
    public void Srgb16FromLinear_AroundEveryThreshold_IsExactlyRounded()
    {
        List<float> thresholds = [];
        for (int code = 1; code < 65536; code++)
        {
            thresholds.Add(Smallest(light => ColorEncoding.Srgb16FromLinear(light) >= code));
        }

        Assert.Equal(0x74DEE10C777CEE87ul, Fnv(thresholds));
    }

    [Fact]
    public void Encode_EveryCodeDecoded_ComesBack()
    {
        for (int code = 0; code < 256; code++)
        {
            Assert.Equal(code, ColorEncoding.Srgb8FromLinear(ColorEncoding.LinearFromSrgb8((byte)code)));
        }

        for (int code = 0; code < 65536; code++)
        {
            Assert.Equal(code, ColorEncoding.Srgb16FromLinear(ColorEncoding.LinearFromSrgb16((ushort)code)));
        }
    }

    [Theory]
    [InlineData(float.NaN, 0)]
    [InlineData(float.NegativeInfinity, 0)]
    [InlineData(-1f, 0)]
    [InlineData(-0f, 0)]
    [InlineData(float.Epsilon, 0)]
    [InlineData(1f, 255)]
    [InlineData(1.0000001f, 255)]
    [InlineData(float.MaxValue, 255)]
    [InlineData(float.PositiveInfinity, 255)]
    public void Encode_OutsideOfRange_Clamps(float light, byte code)
    {
        Assert.Equal(code, ColorEncoding.Srgb8FromLinear(light));
        Assert.Equal(code, ColorEncoding.Linear8FromLinear(light));
        Assert.Equal(code * 257, ColorEncoding.Srgb16FromLinear(light));
        Assert.Equal(code * 257, ColorEncoding.Linear16FromLinear(light));
    }

    [Theory]
    [InlineData(0.5f, 128)]
    [InlineData(0.00196078f, 0)] // just below 0.5 / 255
    [InlineData(0.00196079f, 1)]
    [InlineData(0.2f, 51)]
    [InlineData(0.998f, 254)] // 254.49
    public void Linear8FromLinear_Light_IsFloorOf255TimesPlusHalf(float light, byte code) =>
        Assert.Equal(code, ColorEncoding.Linear8FromLinear(light));

    [Theory]
    [InlineData(0.2, 0.78600308559662276467)]
    [InlineData(2.2, 0.070740277703696029401)]
    [InlineData(5.0, 0.0024299999999999995504)]
    [InlineData(1 / 2.4, 0.60552747873010194598)]
    public void Pow_OfThreeTenths_IsWithinTwoUlp(double exponent, double exact) =>
        Assert.InRange(PortablePower.Pow(0.3, exponent), exact - (2 * Math.ScaleB(exact, -52)), exact + (2 * Math.ScaleB(exact, -52)));

    [Theory]
    [InlineData(0.2)]
    [InlineData(1.8)]
    [InlineData(2.2)]
    [InlineData(5)]
    public void GammaTable_EveryCode_ComesBack(double exponent)
    {
        TransferFunction gamma = TransferFunction.Gamma(exponent);
        CodeTable table = new(gamma, 255);
        CodeTable deep = new(gamma, 65535);
        ReadOnlySpan<float> decoded = ColorEncoding.DecodeTable(gamma, PixelFormat.Rgba8);
        for (int code = 0; code < 256; code++)
        {
            Assert.Equal(code, table.Encode(decoded[code]));
            Assert.Equal(code * 257, deep.Encode(decoded[code]));
        }
    }

    [Theory]
    [InlineData(0.1)]
    [InlineData(5.1)]
    [InlineData(double.NaN)]
    public void Gamma_OutsideOfRange_Throws(double exponent) =>
        Assert.Throws<ArgumentOutOfRangeException>(() => TransferFunction.Gamma(exponent));

    /// <summary>Smallest float in [0, 1] for which a monotonic condition holds, by bisection of its bits.</summary>
    private static float Smallest(Func<float, bool> condition)
    {
        int low = 0;
        int high = BitConverter.SingleToInt32Bits(1f);
        while (low < high)
        {
            int middle = (low + high) / 2;
            (low, high) = condition(BitConverter.Int32BitsToSingle(middle)) ? (low, middle) : (middle + 1, high);
        }

        return BitConverter.Int32BitsToSingle(low);
    }

    private static ulong Fnv(IEnumerable<float> values) =>
        values.Aggregate(FnvStart, (hash, value) => unchecked((hash ^ BitConverter.SingleToUInt32Bits(value)) * FnvPrime));
}
