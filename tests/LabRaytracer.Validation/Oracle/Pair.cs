namespace LabRaytracer.Validation;

/// <summary>A number in two doubles, about 104 bits: the quick form of the oracle, for numbers whose parts neither overflow nor underflow.</summary>
/// <remarks>
/// Written apart from the library, whose numbers it judges. Source of sum, product and quotient: Joldes, Muller, Popescu, "Tight and rigorous error bounds for basic
/// building blocks of double-word arithmetic", ACM TOMS 44(2), 2017.
/// </remarks>
internal readonly record struct Pair(double High, double Low)
{
    public static implicit operator Pair(double a) => new(a, 0);

    public static Pair operator +(Pair a, Pair b)
    {
        Pair high = Sum(a.High, b.High), low = Sum(a.Low, b.Low);
        Pair sum = Ordered(high.High, high.Low + low.High);
        return Ordered(sum.High, low.Low + sum.Low);
    }

    public static Pair operator -(Pair a) => new(-a.High, -a.Low);

    public static Pair operator -(Pair a, Pair b) => a + (-b);

    public static Pair operator *(Pair a, Pair b)
    {
        double product = a.High * b.High, rest = Math.FusedMultiplyAdd(a.High, b.High, -product);
        rest += Math.FusedMultiplyAdd(a.High, b.Low, a.Low * b.High);
        return Ordered(product, rest);
    }

    public static Pair operator /(Pair a, Pair b)
    {
        double first = a.High / b.High;
        Pair rest = a - (b * first);
        double second = rest.High / b.High;
        rest -= b * second;
        return Ordered(first, second) + (rest.High / b.High);
    }

    /// <summary>a + b, exactly.</summary>
    public static Pair Sum(double a, double b)
    {
        double sum = a + b, part = sum - a;
        return new Pair(sum, (a - (sum - part)) + (b - part));
    }

    /// <summary>Square root of a number above 0.</summary>
    public static Pair Sqrt(Pair a)
    {
        double root = Math.Sqrt(a.High);
        Pair rest = a - (new Pair(root, 0) * root);
        return Ordered(root, rest.High / (2 * root));
    }

    /// <summary>The nearest pair to an exact number.</summary>
    public static Pair Of(Real exact)
    {
        double high = Truth.Nearest(exact, false);
        return new Pair(high, Truth.Nearest(exact - high, false));
    }

    /// <summary>The number times a power of two; exact while nothing underflows.</summary>
    public Pair Scaled(int power) => new(Math.ScaleB(High, power), Math.ScaleB(Low, power));

    /// <summary>Exactly.</summary>
    public Real ToReal() => (Real)High + Low;

    /// <summary>How far a number is from this one, in ulp of this one in the number's format.</summary>
    public double Ulps(double found, bool isSingle)
    {
        if (!double.IsFinite(found))
        {
            return double.PositiveInfinity;
        }

        int exponent = High == 0 ? -1074 : Math.ILogB(High);
        exponent -= Math.ScaleB(1, exponent) == Math.Abs(High) && Low != 0 && Low > 0 != High > 0 ? 1 : 0;
        int unit = Math.Max(exponent - (isSingle ? 23 : 52), isSingle ? -149 : -1074);
        return Math.Abs(Math.ScaleB((found - High) - Low, -unit));
    }

    private static Pair Ordered(double a, double b)
    {
        double sum = a + b;
        return new Pair(sum, b - (sum - a));
    }
}
