using System.Globalization;

namespace LabRaytracer;

/// <summary>Reads decimal numbers: the double nearest to what is written.</summary>
internal static class DecimalText
{
    // Powers of ten that a double holds exactly: one multiplication or division by them rounds once.
    private static readonly double[] s_exactPowers =
    [
        1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22,
    ];

    /// <summary>Reads a number such as -1.5e-3 at the start of a text.</summary>
    /// <param name="text">The text.</param>
    /// <param name="value">The double nearest to it, ties to even; infinite where it is too large.</param>
    /// <returns>How many bytes it takes; 0 if there is no number.</returns>
    public static int Read(ReadOnlySpan<byte> text, out double value)
    {
        int at = text.Length > 0 && text[0] is (byte)'-' or (byte)'+' ? 1 : 0;
        ulong digits = 0;
        int start = at;
        at = ReadDigits(text, at, ref digits);
        int count = at - start, scale = 0;
        if (at < text.Length && text[at] == '.')
        {
            int point = at + 1;
            at = ReadDigits(text, point, ref digits);
            scale = point - at;
            count -= scale;
        }

        value = 0;
        if (count == 0)
        {
            return 0;
        }

        at = ReadExponent(text, at, out int exponent);
        scale += exponent;

        // 15 digits fit into 53 bits; 19 would fit into 64, but not be exact as a double.
        if (count <= 15 && scale is >= -22 and <= 22)
        {
            double exact = scale < 0 ? digits / s_exactPowers[-scale] : digits * s_exactPowers[scale];
            value = text[0] == '-' ? -exact : exact;
        }
        else
        {
            value = double.Parse(text[..at], NumberStyles.Float, CultureInfo.InvariantCulture);
        }

        return at;
    }

    private static int ReadDigits(ReadOnlySpan<byte> text, int at, ref ulong digits)
    {
        ulong all = digits;
        uint digit;
        while (at < text.Length && (digit = (uint)(text[at] - '0')) <= 9)
        {
            all = (all * 10) + digit;
            at++;
        }

        digits = all;
        return at;
    }

    // An "e" without digits after it is not part of the number.
    private static int ReadExponent(ReadOnlySpan<byte> text, int at, out int exponent)
    {
        exponent = 0;
        if (at >= text.Length || (text[at] | 0x20) != 'e')
        {
            return at;
        }

        int sign = at + 1;
        int digit = sign < text.Length && text[sign] is (byte)'-' or (byte)'+' ? sign + 1 : sign;
        int end = digit;
        while (end < text.Length && (uint)(text[end] - '0') <= 9)
        {
            exponent = Math.Min((exponent * 10) + (text[end++] - '0'), 100_000);
        }

        exponent = sign < text.Length && text[sign] == '-' ? -exponent : exponent;
        return end == digit ? at : end;
    }
}
