using System.Numerics;

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
        ulong a = 1;
        ulong b = 0;
        while (data.Length > 0)
        {
            ReadOnlySpan<byte> part = data[..Math.Min(MostBytes, data.Length)];
            data = data[part.Length..];
            AppendVectors(ref part, ref a, ref b);
            foreach (byte value in part)
            {
                a += value;
                b += a;
            }

            a %= Modulus;
            b %= Modulus;
        }

        return (uint)((b << 16) | a);
    }

    /// <summary>Takes as many bytes as fill whole vectors.</summary>
    private static void AppendVectors(ref ReadOnlySpan<byte> data, ref ulong a, ref ulong b)
    {
        // Lane i adds up the bytes i, i + n, i + 2n, ... in sums, and what sums was before each of them in earlier.
        int vectors = data.Length / Vector<byte>.Count;
        Vector<uint> sums0 = default, sums1 = default, sums2 = default, sums3 = default;
        Vector<uint> earlier0 = default, earlier1 = default, earlier2 = default, earlier3 = default;
        for (int vector = 0; vector < vectors; vector++)
        {
            Vector.Widen(new Vector<byte>(data[(vector * Vector<byte>.Count)..]), out Vector<ushort> low, out Vector<ushort> high);
            Vector.Widen(low, out Vector<uint> bytes0, out Vector<uint> bytes1);
            Vector.Widen(high, out Vector<uint> bytes2, out Vector<uint> bytes3);
            earlier0 += sums0;
            earlier1 += sums1;
            earlier2 += sums2;
            earlier3 += sums3;
            sums0 += bytes0;
            sums1 += bytes1;
            sums2 += bytes2;
            sums3 += bytes3;
        }

        b += a * (ulong)(vectors * Vector<byte>.Count);
        Add(sums0, earlier0, 0, ref a, ref b);
        Add(sums1, earlier1, 1, ref a, ref b);
        Add(sums2, earlier2, 2, ref a, ref b);
        Add(sums3, earlier3, 3, ref a, ref b);
        data = data[(vectors * Vector<byte>.Count)..];
    }

    /// <summary>Adds a quarter of the lanes: a byte counts in b once for itself and for every byte after it.</summary>
    private static void Add(Vector<uint> sums, Vector<uint> earlier, int quarter, ref ulong a, ref ulong b)
    {
        for (int i = 0; i < Vector<uint>.Count; i++)
        {
            int lane = (quarter * Vector<uint>.Count) + i;
            a += sums[i];
            b += (earlier[i] * (ulong)Vector<byte>.Count) + (sums[i] * (ulong)(Vector<byte>.Count - lane));
        }
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
