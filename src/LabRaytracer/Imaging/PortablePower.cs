namespace LabRaytracer;

/// <summary>x^y by + - * / and fma alone, in a fixed order: the same bits on every machine, which <c>Math.Pow</c> does not promise.</summary>
/// <remarks>Relative error below 4e-16 for results between 1e-60 and 1e60. Meant for tables made once, not for pixels.</remarks>
internal static class PortablePower
{
    // 1/ln 2 and ln 2 as unevaluated sums of two doubles (mpmath, 60 digits).
    private const double InverseLn2High = 1.4426950408889634;
    private const double InverseLn2Low = 2.0355273740931033e-17;
    private const double Ln2High = 0.6931471805599453;
    private const double Ln2Low = 2.3190468138462996e-17;
    private const double SqrtHalf = 0.7071067811865476;

    /// <summary>Positive finite <paramref name="x"/> to the power <paramref name="y"/>; infinity if it overflows, 0 if it underflows.</summary>
    public static double Pow(double x, double y)
    {
        if (double.IsPositiveInfinity(x))
        {
            return x;
        }

        (double high, double low) = Log2(x);
        double product = high * y;
        double rest = Math.FusedMultiplyAdd(high, y, -product) + (low * y);
        double whole = Math.Round(product);
        return Math.ScaleB(Exp2Fraction(product - whole, rest), (int)Math.Clamp(whole, -2000, 2000));
    }

    /// <summary>log2 as a sum of two doubles, from ln m = 2 artanh((m - 1) / (m + 1)).</summary>
    private static (double High, double Low) Log2(double x)
    {
        int exponent = Math.ILogB(x);
        double m = Math.ScaleB(x, -exponent) / 2;
        exponent++;
        if (m < SqrtHalf)
        {
            m *= 2;
            exponent--;
        }

        // s = (m - 1) / (m + 1) with its rounding error; m - 1 is exact, m + 1 is split exactly.
        double numerator = m - 1;
        double denominator = m + 1;
        double denominatorLow = m - (denominator - 1);
        double s = numerator / denominator;
        double remainder = Math.FusedMultiplyAdd(-s, denominator, numerator);
        double sLow = (remainder - (s * denominatorLow)) / denominator;

        double z = s * s;
        double series = 0;
        for (int n = 25; n >= 3; n -= 2)
        {
            series = (series * z) + (1.0 / n);
        }

        (double high, double low) = (s, sLow + (s * z * series));
        double sum = high + low;
        low -= sum - high;

        double product = 2 * sum * InverseLn2High;
        double productLow = Math.FusedMultiplyAdd(2 * sum, InverseLn2High, -product)
            + (2 * ((sum * InverseLn2Low) + (low * InverseLn2High)));
        double total = exponent + product;
        double fromExponent = total - product;
        double error = (exponent - fromExponent) + (product - (total - fromExponent));
        return (total, error + productLow);
    }

    /// <summary>2^(f + rest) for |f| at most 1/2, by the Taylor series of exp.</summary>
    private static double Exp2Fraction(double f, double rest)
    {
        double t = f * Ln2High;
        double tLow = Math.FusedMultiplyAdd(f, Ln2High, -t) + (f * Ln2Low) + (rest * Ln2High);
        double series = 0;
        for (int n = 18; n >= 2; n--)
        {
            series = (series * t / (n + 1)) + 1;
        }

        // exp(t) = 1 + t + t^2/2 (...): the small terms are added first.
        double tail = (t * t / 2 * series) + tLow + (tLow * t);
        double sum = 1 + t;
        return sum + ((t - (sum - 1)) + tail);
    }
}
