using System.Numerics;

namespace LabRaytracer.Validation;

/// <summary>Elementary functions of the oracle, to more than 180 bits.</summary>
internal static class Truth
{
    private const int Bits = 256, Slots = 64, ArctanTerms = 20;

    private static readonly BigInteger s_one = BigInteger.One << Bits;
    private static readonly Real s_pi = ComputePi();
    private static readonly Real s_ln2 = 2 * InverseTangentHyperbolic((Real)1 / 3);
    private static readonly Real[] s_arctan = ArctanTable();

    /// <summary>1 / (2 pi).</summary>
    public static Real TurnsPerRadian => 1 / (2 * s_pi);

    /// <summary>The arctangent of a 64th part of 1, times a whole number up to 64, radians.</summary>
    public static Real ArctanOfSlot(int slot) => s_arctan[slot];

    /// <summary>Angle of (y, x) in turns, [0, 1): 0 on the half axis x >= 0, growing towards y.</summary>
    public static Real Atan2Turns(Real y, Real x)
    {
        Real ay = Real.Abs(y), ax = Real.Abs(x);
        if (ay.Sign == 0 && ax.Sign == 0)
        {
            return 0;
        }

        bool isSteep = ay > ax;
        Real turns = Real.Short(Arctan(isSteep ? ax / ay : ay / ax) / (2 * s_pi));
        turns = isSteep ? 0.25 - turns : turns;
        turns = x.Sign < 0 ? 0.5 - turns : turns;
        return y.Sign < 0 && turns.Sign != 0 ? 1 - turns : turns;
    }

    /// <summary>(u, v) of the spherical mapping: lab sheet IV, section 1.1.3, with the origin at (0, 1/2).</summary>
    public static (Real U, Real V) Sphere(Real x, Real y, Real z)
    {
        Real radius = Hypotenuse(x, z);
        return (Atan2Turns(x, z), radius.Sign == 0 && y.Sign == 0 ? 0.5 : 2 * Atan2Turns(radius, -y));
    }

    /// <summary>sqrt(x² + z²).</summary>
    public static Real Hypotenuse(Real x, Real z) => Real.Sqrt(Real.Short((x * x) + (z * z), 400));

    /// <summary>Sine and cosine of an angle in turns.</summary>
    public static (Real Sin, Real Cos) SinCosTurns(Real turns)
    {
        BigInteger quarters = Real.Floor((4 * turns) + 0.5);
        Real angle = 2 * s_pi * (turns - ((double)(quarters % 4) / 4) - Real.FromFixed(quarters / 4, 0));
        (Real sin, Real cos) = (Taylor(angle, 1), Taylor(angle, 0));
        return (int)(((quarters % 4) + 4) % 4) switch
        {
            0 => (sin, cos),
            1 => (cos, -sin),
            2 => (-sin, -cos),
            _ => (-cos, sin),
        };
    }

    /// <summary>2^x.</summary>
    public static Real Exp2(Real x)
    {
        BigInteger whole = Real.Floor(x + 0.5);
        Real power = Real.Short((x - Real.FromFixed(whole, 0)) * s_ln2);
        Real sum = 1, term = 1;
        for (int n = 1; n < 60 && term.Sign != 0; n++)
        {
            term = Real.Short(term * power / n);
            sum += term;
        }

        return Real.Scale(Real.Short(sum), (int)whole);
    }

    /// <summary>log2(x) of x above 0.</summary>
    public static Real Log2(Real x)
    {
        int exponent = x.Exponent;
        Real mantissa = Real.Scale(x, -exponent);
        if (mantissa > 1.4142135623730951)
        {
            exponent++;
            mantissa = Real.Scale(mantissa, -1);
        }

        return exponent + (2 * InverseTangentHyperbolic((mantissa - 1) / (mantissa + 1)) / s_ln2);
    }

    /// <summary>x^y of x above 0.</summary>
    public static Real Pow(Real x, Real y) => Exp2(Real.Short(y * Log2(x), 400));

    /// <summary>Linear light of an sRGB value in [0, 1]: IEC 61966-2-1 with its decimal constants.</summary>
    public static Real SrgbDecode(Real encoded) => encoded * 100000 <= 4045
        ? encoded * 100 / 1292
        : Pow(((encoded * 1000) + 55) / 1055, (Real)12 / 5);

    /// <summary>How far a number is from the exact one, in ulp of the exact one in its format; infinite for NaN and infinities.</summary>
    public static double Ulps(double found, Real exact, bool isSingle)
    {
        if (!double.IsFinite(found))
        {
            return double.PositiveInfinity;
        }

        int lowest = isSingle ? -149 : -1074;
        int unit = exact.Sign == 0 ? lowest : Math.Max(exact.Exponent - (isSingle ? 23 : 52), lowest);
        return Math.Abs(Real.Scale(found - exact, -unit).ToDouble());
    }

    /// <summary>The number nearest to the exact one in float or double.</summary>
    public static double Nearest(Real exact, bool isSingle)
    {
        double guess = isSingle ? (float)exact.ToDouble() : exact.ToDouble();
        double best = guess;
        foreach (double other in isSingle
            ? new double[] { MathF.BitDecrement((float)guess), MathF.BitIncrement((float)guess) }
            : [Math.BitDecrement(guess), Math.BitIncrement(guess)])
        {
            best = double.IsFinite(other) && Real.Abs(other - exact) < Real.Abs(best - exact) ? other : best;
        }

        return best;
    }

    /// <summary>Arctangent in radians of a quotient in [0, 1].</summary>
    private static Real Arctan(Real quotient)
    {
        int slot = (int)Real.Floor((quotient * Slots) + 0.5);
        Real near = (double)slot / Slots;
        Real rest = slot == 0 ? quotient : (quotient - near) / (1 + (quotient * near));
        return s_arctan[slot] + ArctanSeries(Real.Short(rest), ArctanTerms);
    }

    private static Real ArctanSeries(Real x, int terms)
    {
        BigInteger square = Real.ToFixed(x * x, Bits), sum = 0;
        for (int n = terms; n >= 0; n--)
        {
            sum = (s_one / ((2 * n) + 1)) - ((square * sum) >> Bits);
        }

        return Real.Short(x * Real.FromFixed(sum, Bits));
    }

    private static Real[] ArctanTable()
    {
        Real[] table = new Real[Slots + 1];
        table[0] = 0;
        for (int k = 1; k <= Slots; k++)
        {
            Real step = (Real)Slots / ((Slots * Slots) + (k * (k - 1)));
            table[k] = table[k - 1] + ArctanSeries(step, ArctanTerms);
        }

        return table;
    }

    /// <summary>Machin's formula.</summary>
    private static Real ComputePi() => (16 * ArctanSeries((Real)1 / 5, 60)) - (4 * ArctanSeries((Real)1 / 239, 60));

    private static Real InverseTangentHyperbolic(Real x)
    {
        Real square = Real.Short(x * x), power = x, sum = x;
        for (int n = 3; n < 200 && power.Sign != 0 && power.Exponent > -240; n += 2)
        {
            power = Real.Short(power * square);
            sum += power / n;
        }

        return Real.Short(sum);
    }

    /// <summary>The sine (first power 1) or the cosine (0) of a small angle.</summary>
    private static Real Taylor(Real angle, int first)
    {
        Real square = -Real.Short(angle * angle), term = first == 1 ? angle : 1, sum = term;
        for (int n = first + 1; n < 60 && term.Sign != 0; n += 2)
        {
            term = Real.Short(term * square / (n * (n + 1)));
            sum += term;
        }

        return Real.Short(sum);
    }
}
