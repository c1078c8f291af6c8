using System.Numerics;

namespace LabRaytracer;

/// <summary>A whole number times a power of two, with as many digits as it takes: sums, differences and products of doubles are exact.</summary>
/// <remarks>A thousand times slower than a double; for the few decisions that twice a double's digits leave open.</remarks>
internal readonly struct ExactNumber
{
    private readonly BigInteger _digits;
    private readonly int _power;

    private ExactNumber(BigInteger digits, int power) => (_digits, _power) = (digits, power);

    /// <summary>-1, 0 or 1.</summary>
    public int Sign => _digits.Sign;

    /// <summary>Exactly a finite double.</summary>
    public static implicit operator ExactNumber(double value)
    {
        long bits = BitConverter.DoubleToInt64Bits(value);
        int exponent = (int)((bits >> 52) & 0x7FF);
        ArgumentOutOfRangeException.ThrowIfEqual(exponent, 0x7FF, nameof(value));
        long digits = (bits & 0xFFFFFFFFFFFFF) | (exponent == 0 ? 0 : 1L << 52);
        return new ExactNumber(bits < 0 ? -digits : digits, Math.Max(exponent, 1) - 1075);
    }

    public static ExactNumber operator +(ExactNumber a, ExactNumber b)
    {
        (ExactNumber high, ExactNumber low) = a._power >= b._power ? (a, b) : (b, a);
        return new ExactNumber((high._digits << (high._power - low._power)) + low._digits, low._power);
    }

    public static ExactNumber operator -(ExactNumber a) => new(-a._digits, a._power);

    public static ExactNumber operator -(ExactNumber a, ExactNumber b) => a + (-b);

    public static ExactNumber operator *(ExactNumber a, ExactNumber b) => new(a._digits * b._digits, a._power + b._power);

    /// <summary>Half the number.</summary>
    public ExactNumber Half() => new(_digits, _power - 1);

    /// <summary>The double nearest to a number above 0 of which nothing is known but its comparisons; between two, the even one; at most the largest finite double.</summary>
    /// <param name="compareTo">The sign of the unknown number minus the given one.</param>
    public static double Nearest(Func<ExactNumber, int> compareTo)
    {
        // Doubles above 0 are ordered as their bits are.
        long below = 0, above = BitConverter.DoubleToInt64Bits(double.PositiveInfinity);
        while (above - below > 1)
        {
            long middle = below + ((above - below) / 2);
            (below, above) = compareTo(BitConverter.Int64BitsToDouble(middle)) < 0 ? (below, middle) : (middle, above);
        }

        double lower = BitConverter.Int64BitsToDouble(below), upper = BitConverter.Int64BitsToDouble(above);
        if (double.IsInfinity(upper))
        {
            return lower;
        }

        int side = compareTo(((ExactNumber)lower + upper).Half());
        bool isUpper = side > 0 || (side == 0 && (above & 1) == 0);
        return isUpper ? upper : lower;
    }
}
