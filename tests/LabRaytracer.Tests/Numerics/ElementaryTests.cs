namespace LabRaytracer.Tests;

/// <summary>Exact cases, ends of ranges, and equal bits at every width of the elementary functions.</summary>
public sealed class ElementaryTests
{
    [Theory]
    [InlineData(0, 0, 1)]
    [InlineData(0.25, 1, 0)]
    [InlineData(0.5, 0, -1)]
    [InlineData(0.75, -1, 0)]
    [InlineData(1, 0, 1)]
    [InlineData(-0.25, -1, 0)]
    [InlineData(-0.5, 0, -1)]
    [InlineData(1000000.25, 1, 0)]
    [InlineData(-7.75, 1, 0)]
    [InlineData(4503599627370497.0, 0, 1)]
    [InlineData(1e300, 0, 1)]
    public void SinCosTurns_MultipleOfAQuarter_IsExact(double turns, double sin, double cos)
    {
        (Double1 s, Double1 c) = Elementary.SinCosTurns(new Double1(turns));
        Assert.Equal(sin, s.Value);
        Assert.Equal(cos, c.Value);
    }

    [Theory]
    [InlineData(0, 0, 1)]
    [InlineData(90, 1, 0)]
    [InlineData(-90, -1, 0)]
    [InlineData(180, 0, -1)]
    [InlineData(270, -1, 0)]
    [InlineData(360, 0, 1)]
    [InlineData(-810, -1, 0)]
    [InlineData(3.6e17, 0, 1)]
    public void SinCosDegrees_MultipleOf90_IsExact(double degrees, double sin, double cos)
    {
        (double s, double c) = Elementary.SinCosDegrees(degrees);
        Assert.Equal(sin, s);
        Assert.Equal(cos, c);
    }

    [Fact]
    public void TanDegrees_45And0_IsExact()
    {
        Assert.Equal(1, Elementary.TanDegrees(45));
        Assert.Equal(-1, Elementary.TanDegrees(-45));
        Assert.Equal(0, Elementary.TanDegrees(0));
        UlpAssert.Within(2, 0.57735026918962576, Elementary.TanDegrees(30)); // 1 / sqrt(3)
    }

    [Theory]
    [InlineData(0, 0, 1)]
    [InlineData(0, 5, 0)]
    [InlineData(0, 0.001, 0)]
    [InlineData(1, 100000, 1)]
    [InlineData(1, 0.3, 1)]
    [InlineData(0.5, 3, 0.125)]
    [InlineData(0.5, 0, 1)]
    [InlineData(4, 0.5, 2)]
    [InlineData(0.9, 1e5, 0)]
    public void Pow_SpecialCase_IsExact(double x, double y, double expected)
    {
        Assert.Equal(expected, Elementary.Pow(new Float1((float)x), new Float1((float)y)).Value);
        if (x != 0.9)
        {
            Assert.Equal(expected, Elementary.Pow(new Double1(x), new Double1(y)).Value);
        }
    }

    [Theory]
    [InlineData(-2000, 0)]
    [InlineData(-1074, 4.94065645841246544e-324)]
    [InlineData(-1, 0.5)]
    [InlineData(0, 1)]
    [InlineData(1023, 8.98846567431157954e307)]
    [InlineData(5000, double.PositiveInfinity)]
    [InlineData(double.PositiveInfinity, double.PositiveInfinity)]
    [InlineData(double.NegativeInfinity, 0)]
    public void Exp2_Integer_IsExact(double x, double expected) => Assert.Equal(expected, Elementary.Exp2(new Double1(x)).Value);

    [Theory]
    [InlineData(1, 0)]
    [InlineData(2, 1)]
    [InlineData(0.125, -3)]
    [InlineData(4.94065645841246544e-324, -1074)]
    public void Log2_PowerOfTwo_IsExact(double x, double expected) => Assert.Equal(expected, Elementary.Log2(new Double1(x)).Value);

    [Theory]
    [InlineData(0.25, 0.25, 0.25, 0.25)]
    [InlineData(1, 0, 1, 1)]
    [InlineData(-0.25, 0.75, 0.25, 0)]
    [InlineData(1.25, 0.25, 0.75, 1)]
    [InlineData(2.25, 0.25, 0.25, 1)]
    [InlineData(-1e-30, 0, 1e-30, 0)]
    [InlineData(-3, 0, 1, 0)]
    [InlineData(1e18, 0, 0, 1)]
    public void Wrap_Coordinate_MatchesDefinition(double u, double repeat, double mirror, double clamp)
    {
        Assert.Equal(repeat, Elementary.WrapRepeat(new Double1(u)).Value);
        Assert.Equal(mirror, Elementary.WrapMirror(new Double1(u)).Value);
        Assert.Equal(clamp, Elementary.WrapClamp(new Double1(u)).Value);
        Assert.InRange(Elementary.WrapRepeat(new Float1((float)u)).Value, 0, MathF.BitDecrement(1));
    }

    [Fact]
    public void Functions_EveryWidth_SameBits()
    {
        var random = new Random(99);
        double[] a = [.. Enumerable.Range(0, 4000).Select(i => Math.ScaleB(random.NextDouble(), random.Next(-20, 4)) * (i % 2 == 0 ? 1 : -1))];
        double[] b = [.. Enumerable.Range(0, 4000).Select(_ => random.NextDouble() * 300)];
        double[] wide = Everything<Double1>(a, b);
        Assert.Equal(wide, Everything<Double4>(a, b));
        Assert.Equal(wide, Everything<Double8>(a, b));
        Assert.Equal(wide, Everything<Double16>(a, b));
        double[] narrow = Everything<Float1>(a, b);
        Assert.Equal(narrow, Everything<Float4>(a, b));
        Assert.Equal(narrow, Everything<Float8>(a, b));
        Assert.Equal(narrow, Everything<Float16>(a, b));
    }

    private static double[] Everything<R>(double[] a, double[] b)
        where R : unmanaged, IReal<R> =>
    [
        .. WideMapping.Apply<R>((x, _) => Elementary.SinCosTurns(x).Sin, a, b),
        .. WideMapping.Apply<R>((x, _) => Elementary.SinCosTurns(x).Cos, a, b),
        .. WideMapping.Apply<R>((x, _) => Elementary.Exp2(x), a, b),
        .. WideMapping.Apply<R>((x, _) => Elementary.Log2(R.Abs(x)), a, b),
        .. WideMapping.Apply<R>((x, y) => Elementary.Pow(R.Min(R.Abs(x), R.Of(1)), y), a, b),
        .. WideMapping.Apply<R>((x, y) => Elementary.Atan2Turns(x, y), a, b),
        .. WideMapping.Apply<R>((x, y) => Elementary.WrapRepeat(x * y), a, b),
        .. WideMapping.Apply<R>((x, y) => Elementary.WrapMirror(x * y), a, b),
    ];
}
