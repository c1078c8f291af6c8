namespace LabRaytracer.Tests;

/// <summary>Every arithmetic operation of every lane type against the scalar operation, on hard operands, bit by bit.</summary>
public sealed class RealLaneTests
{
    private static readonly double[] Hard =
    [
        0.0, -0.0, 1, -1, 0.5, -0.5, 1.5, 2.5, -2.5, -3.7, 0.1, 1 / 3.0, 1e-30, -1e-30, 1e30, 1e-45, -1e-310, 8388609, 4503599627370497,
        float.MaxValue, double.PositiveInfinity, double.NegativeInfinity, double.NaN,
    ];

    [Fact]
    public void Double1_EveryOperation_EqualsScalar() => Check<Double1>();

    [Fact]
    public void Double2_EveryOperation_EqualsScalar() => Check<Double2>();

    [Fact]
    public void Double4_EveryOperation_EqualsScalar() => Check<Double4>();

    [Fact]
    public void Double8_EveryOperation_EqualsScalar() => Check<Double8>();

    [Fact]
    public void Double16_EveryOperation_EqualsScalar() => Check<Double16>();

    [Fact]
    public void Float1_EveryOperation_EqualsScalar() => Check<Float1>();

    [Fact]
    public void Float4_EveryOperation_EqualsScalar() => Check<Float4>();

    [Fact]
    public void Float8_EveryOperation_EqualsScalar() => Check<Float8>();

    [Fact]
    public void Float16_EveryOperation_EqualsScalar() => Check<Float16>();

    [Fact]
    public void LeastAndLargest_InAnyLane_AreFound()
    {
        Extremes<Double1>();
        Extremes<Double2>();
        Extremes<Double4>();
        Extremes<Double8>();
        Extremes<Double16>();
        Extremes<Float1>();
        Extremes<Float4>();
        Extremes<Float8>();
        Extremes<Float16>();
    }

    private static unsafe void Extremes<R>()
        where R : unmanaged, IReal<R>
    {
        for (int lane = 0; lane < R.Width; lane++)
        {
            foreach (double extreme in new[] { 3, -3, double.PositiveInfinity, double.NegativeInfinity })
            {
                R lanes = R.Of(0.5);
                Lane.Put(&lanes, lane, extreme);
                Assert.Equal(R.Width == 1 ? extreme : Math.Max(extreme, 0.5), R.Largest(lanes));
                Assert.Equal(R.Width == 1 ? extreme : Math.Min(extreme, 0.5), Lane.Least(lanes));
            }
        }
    }

    private static void Check<R>()
        where R : unmanaged, IReal<R>
    {
        Binary<R>("+", (a, b) => a + b, (a, b) => a + b);
        Binary<R>("-", (a, b) => a - b, (a, b) => a - b);
        Binary<R>("*", (a, b) => a * b, (a, b) => a * b);
        Binary<R>("/", (a, b) => a / b, (a, b) => a / b);
        Binary<R>("negate", (a, _) => -a, (a, _) => -a);
        Binary<R>("abs", (a, _) => R.Abs(a), (a, _) => Math.Abs(a));
        Binary<R>("sqrt", (a, _) => R.Sqrt(a), (a, _) => Math.Sqrt(a));
        Binary<R>("floor", (a, _) => R.Floor(a), (a, _) => Math.Floor(a));
        Binary<R>("min", R.Min, (a, b) => a < b ? a : b);
        Binary<R>("max", R.Max, (a, b) => a > b ? a : b);
        Binary<R>("fma", (a, b) => R.Fma(a, b, a), (a, b) => Fma<R>(a, b, a));
        Binary<R>("less", (a, b) => R.Select(R.Less(a, b), a, b), (a, b) => a < b ? a : b);
        Binary<R>("lessOrEqual", (a, b) => R.Select(R.LessOrEqual(b, a), a, -b), (a, b) => b <= a ? a : -b);
        Binary<R>("equal", (a, b) => R.Select(R.Equal(a, b), R.Of(7), b), (a, b) => a == b ? 7 : b);
        Binary<R>("and", (a, b) => R.Less(a, b) & a, (a, b) => a < b ? a : 0);
        Binary<R>("or", (a, b) => R.Select(R.Less(a, b) | R.Equal(a, b), a, b), (a, b) => a <= b ? a : b);
        Binary<R>("xor", (a, b) => R.Select(R.LessOrEqual(a, b) ^ R.Equal(a, b), a, b), (a, b) => a < b ? a : b);
        Binary<R>("not", (a, b) => R.Select(~R.Less(a, b), a, b), (a, b) => !(a < b) ? a : b);
        Binary<R>("sign", (a, _) => a ^ R.Of(-0.0), (a, _) => -a);
        Constants<R>();
        Masks<R>();
        Exponents<R>();
    }

    private static double Fma<R>(double a, double b, double c)
        where R : unmanaged, IReal<R> =>
        R.IsSingle ? MathF.FusedMultiplyAdd((float)a, (float)b, (float)c) : Math.FusedMultiplyAdd(a, b, c);

    private static void Binary<R>(string name, Func<R, R, R> lanes, Func<double, double, double> scalar)
        where R : unmanaged, IReal<R>
    {
        double Rounded(double number) => R.IsSingle ? (float)number : number;
        double[] numbers = [.. Hard.Select(Rounded)];
        double[] first = [.. numbers.SelectMany(a => numbers.Select(_ => a))];
        double[] second = [.. numbers.SelectMany(_ => numbers)];
        double[] results = WideMapping.Apply(lanes, first, second);
        for (int i = 0; i < results.Length; i++)
        {
            // A float operation equals the double one rounded to float: 53 digits are more than twice 24 and 2.
            double expected = Rounded(scalar(first[i], second[i]));
            bool same = double.IsNaN(expected) ? double.IsNaN(results[i]) : BitConverter.DoubleToInt64Bits(expected) == BitConverter.DoubleToInt64Bits(results[i]);
            Assert.True(same, $"{typeof(R).Name} {name}({first[i]:R}, {second[i]:R}): expected {expected:R}, got {results[i]:R}.");
        }
    }

    private static void Constants<R>()
        where R : unmanaged, IReal<R>
    {
        for (int lane = 0; lane < R.Width; lane++)
        {
            Assert.Equal(0, R.Get(R.Zero, lane));
            Assert.Equal(R.IsSingle ? 0.1f : 0.1, R.Get(R.Of(0.1), lane));
            Assert.Equal(2.5 + lane, R.Get(R.Iota(2.5), lane));
        }
    }

    private static void Masks<R>()
        where R : unmanaged, IReal<R>
    {
        uint all = (uint)((1L << R.Width) - 1);
        Assert.Equal((0u, false, false), (R.Bits(R.Zero), R.Any(R.Zero), R.All(R.Zero)));
        Assert.Equal((all, true, true), (R.Bits(R.True), R.Any(R.True), R.All(R.True)));
        for (int lane = 0; lane < R.Width; lane++)
        {
            R mask = R.Equal(R.Iota(0), R.Of(lane));
            Assert.Equal((1u << lane, true, R.Width == 1), (R.Bits(mask), R.Any(mask), R.All(mask)));
        }
    }

    private static void Exponents<R>()
        where R : unmanaged, IReal<R>
    {
        (int least, int most) = R.IsSingle ? (-126, 127) : (-1022, 1023);
        for (int n = least; n <= most; n++)
        {
            Assert.Equal(Math.ScaleB(1, n), R.Get(R.PowerOfTwo(R.Of(n)), R.Width - 1));
            Assert.Equal(n, R.Get(R.Exponent(R.Of(Math.ScaleB(1.25, n))), R.Width - 1));
        }
    }
}
