namespace LabRaytracer;

/// <summary>The checksum of zlib streams (RFC 1950), which can be put together from the sums of parts.</summary>
internal static class Adler32
{
    /// <summary>The sum of no bytes.</summary>
    public const uint Empty = 1;

    private const uint Modulus = 65521;

    // The most bytes whose sums fit in 32 bits (RFC 1950, the NMAX of zlib).
    private const int MostBytes = 5552;

    /// <summary>The sum of some bytes.</summary>
    public static uint Compute(ReadOnlySpan<byte> data)
    {
        uint a = 1;
        uint b = 0;
        while (data.Length > 0)
        {
            ReadOnlySpan<byte> part = data[..Math.Min(MostBytes, data.Length)];
            foreach (byte value in part)
            {
                a += value;
                b += a;
            }

            a %= Modulus;
            b %= Modulus;
            data = data[part.Length..];
        }

        return (b << 16) | a;
    }

    /// <summary>The sum of two parts in a row.</summary>
    /// <param name="first">Sum of the first part.</param>
    /// <param name="second">Sum of the second part.</param>
    /// <param name="secondLength">Bytes of the second part.</param>
    public static uint Combine(uint first, uint second, long secondLength)
    {
        ulong length = (ulong)(secondLength % Modulus);
        ulong a1 = first & 0xFFFF;
        ulong a2 = second & 0xFFFF;
        ulong a = (a1 + a2 + Modulus - 1) % Modulus;
        ulong b = ((first >> 16) + (second >> 16) + (length * (a1 + Modulus - 1))) % Modulus;
        return (uint)((b << 16) | a);
    }
}
