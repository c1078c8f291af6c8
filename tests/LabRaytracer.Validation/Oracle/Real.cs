using System.Numerics;

namespace LabRaytracer.Validation;

/// <summary>A number with up to 512 significant bits: what the sweeps take for the truth.</summary>
/// <remarks>
/// A whole number times a power of two. Sums, differences and products of a few doubles are exact, so signs of polynomials are; quotients and square roots have
/// 256 bits. OracleTests of the validation compare with rows made by mpmath at 60 digits.
/// </remarks>
internal readonly struct Real : IComparable<Real>
{
    private const int Most = 512, Quotient = 256;

    private readonly BigInteger _digits;
    private readonly int _power;

    private Real(BigInteger digits, int power)
    {
        int excess = Length(digits) - Most;
        (_digits, _power) = excess > 0 ? (digits >> excess, power + excess) : (digits, power);
    }

    /// <summary>-1, 0 or 1.</summary>
    public int Sign => _digits.Sign;

    /// <summary>floor(log2 |a|); meaningless for 0.</summary>
    public int Exponent => Length(_digits) - 1 + _power;

    /// <summary>Exactly a finite double.</summary>
    public static implicit operator Real(double value)
    {
        long bits = BitConverter.DoubleToInt64Bits(value);
        int exponent = (int)((bits >> 52) & 0x7FF);
        if (exponent == 0x7FF)
        {
            throw new ArgumentOutOfRangeException(nameof(value), value, "The oracle takes finite numbers only.");
        }

        long digits = (bits & 0xFFFFFFFFFFFFF) | (exponent == 0 ? 0 : 1L << 52);
        return new Real(bits < 0 ? -digits : digits, Math.Max(exponent, 1) - 1075);
    }

    public static Real operator +(Real a, Real b)
    {
        if (a.Sign == 0 || b.Sign == 0)
        {
            return a.Sign == 0 ? b : a;
        }

        // What lies far below the last digit kept cannot be seen.
        (Real high, Real low) = a._power >= b._power ? (a, b) : (b, a);
        int shift = high._power - low._power;
        return high.Exponent - low.Exponent > Most + 2 ? high : new Real((high._digits << shift) + low._digits, low._power);
    }

    public static Real operator -(Real a, Real b) => a + (-b);

    public static Real operator -(Real a) => new(-a._digits, a._power);

    public static Real operator *(Real a, Real b) => new(a._digits * b._digits, a._power + b._power);

    public static Real operator /(Real a, Real b)
    {
        int shift = Math.Max(0, Quotient + Length(b._digits) - Length(a._digits));
        return new Real((a._digits << shift) / b._digits, a._power - b._power - shift);
    }

    public static bool operator <(Real a, Real b) => a.CompareTo(b) < 0;

    public static bool operator >(Real a, Real b) => a.CompareTo(b) > 0;

    public static bool operator <=(Real a, Real b) => a.CompareTo(b) <= 0;

    public static bool operator >=(Real a, Real b) => a.CompareTo(b) >= 0;

    public static Real Abs(Real a) => new(BigInteger.Abs(a._digits), a._power);

    /// <summary>Square root; 0 for 0.</summary>
    public static Real Sqrt(Real a)
    {
        if (a.Sign == 0)
        {
            return a;
        }

        int shift = Math.Max(0, (2 * Quotient) - Length(a._digits));
        shift += (a._power - shift) & 1;
        return new Real(Root(a._digits << shift), (a._power - shift) / 2);
    }

    /// <summary>a times a power of two.</summary>
    public static Real Scale(Real a, int power) => new(a._digits, a._power + power);

    /// <summary>Largest whole number not above.</summary>
    public static BigInteger Floor(Real a) => a._power >= 0 ? a._digits << a._power : a._digits >> -a._power;

    /// <summary>The number cut to a number of significant bits, so that what follows is quick.</summary>
    public static Real Short(Real a, int bits = 256)
    {
        int excess = Length(a._digits) - bits;
        return excess > 0 ? new Real(a._digits >> excess, a._power + excess) : a;
    }

    /// <summary>Fixed point: floor(a 2^bits).</summary>
    public static BigInteger ToFixed(Real a, int bits)
    {
        int shift = a._power + bits;
        return shift >= 0 ? a._digits << shift : a._digits >> -shift;
    }

    /// <summary>Of fixed point: digits / 2^bits.</summary>
    public static Real FromFixed(BigInteger digits, int bits) => new(digits, -bits);

    public int CompareTo(Real other) => (this - other).Sign;

    /// <summary>A double near the number (a few ulp).</summary>
    public double ToDouble()
    {
        int excess = Length(_digits) - 62;
        double digits = excess > 0 ? (double)(_digits >> excess) : (double)_digits;
        return Math.ScaleB(digits, _power + Math.Max(excess, 0));
    }

    public override string ToString() => FormattableString.Invariant($"{ToDouble():R}");

    private static int Length(BigInteger a) => a.Sign == 0 ? 0 : (int)BigInteger.Abs(a).GetBitLength();

    /// <summary>floor(sqrt(a)) by Newton's method from above.</summary>
    private static BigInteger Root(BigInteger a)
    {
        int shift = Math.Max(0, (Length(a) - 100) / 2 * 2);
        BigInteger x = ((BigInteger)Math.Sqrt((double)(a >> shift)) + 2) << (shift / 2);
        while (true)
        {
            BigInteger next = (x + (a / x)) >> 1;
            if (next >= x)
            {
                return x;
            }

            x = next;
        }
    }
}
