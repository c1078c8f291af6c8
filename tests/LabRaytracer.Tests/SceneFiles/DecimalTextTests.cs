using System.Globalization;
using System.Text;

namespace LabRaytracer.Tests.SceneFiles;

public sealed class DecimalTextTests
{
    [Theory]
    [InlineData("0", 1)]
    [InlineData("-0.5x", 4)]
    [InlineData("1.", 2)]
    [InlineData(".5", 2)]
    [InlineData("+1e3", 4)]
    [InlineData("1e", 1)]
    [InlineData("1e+", 1)]
    [InlineData("1e5 2", 3)]
    [InlineData("", 0)]
    [InlineData("-", 0)]
    [InlineData(".", 0)]
    [InlineData("e5", 0)]
    [InlineData("nan", 0)]
    [InlineData("inf", 0)]
    public void Read_Text_TakesTheNumberAlone(string text, int length) => Assert.Equal(length, DecimalText.Read(Encoding.ASCII.GetBytes(text), out _));

    [Theory]
    [InlineData("9007199254740993", 9007199254740992.0)]
    [InlineData("9007199254740993.0000000000001", 9007199254740994.0)]
    [InlineData("2.2250738585072011e-308", 2.225073858507201e-308)]
    [InlineData("123456789012345e22", 1.23456789012345e36)]
    [InlineData("-0", -0.0)]
    [InlineData("1e400", double.PositiveInfinity)]
    public void Read_HardNumber_IsTheNearestDouble(string text, double expected)
    {
        DecimalText.Read(Encoding.ASCII.GetBytes(text), out double value);
        Assert.Equal(BitConverter.DoubleToInt64Bits(expected), BitConverter.DoubleToInt64Bits(value));
    }

    [Fact]
    public void Read_TwentyThousandRandomNumbers_EqualsTheFrameworkBitForBit()
    {
        Random random = new(7);
        for (int i = 0; i < 20_000; i++)
        {
            string text = RandomNumber(random);
            int length = DecimalText.Read(Encoding.ASCII.GetBytes(text), out double value);
            Assert.Equal(text.Length, length);
            double expected = double.Parse(text, NumberStyles.Float, CultureInfo.InvariantCulture);
            Assert.True(BitConverter.DoubleToInt64Bits(expected) == BitConverter.DoubleToInt64Bits(value), text);
        }
    }

    private static string RandomNumber(Random random)
    {
        StringBuilder text = new(random.Next(3) switch { 0 => "-", 1 => "+", _ => "" });
        int digits = random.Next(1, 22), point = random.Next(0, digits + 4);
        for (int i = 0; i < digits; i++)
        {
            text.Append(i == point ? "." : "").Append((char)('0' + random.Next(10)));
        }

        return random.Next(2) == 0 ? text.ToString() : text.Append('e').Append(random.Next(-40, 40)).ToString();
    }
}
