using System.Runtime.Intrinsics;

namespace LabRaytracer;

/// <summary>Evenly distributed numbers for many things at once.</summary>
internal static unsafe class LaneRandom
{
    private const int Width = 4;

    /// <summary>Places at random in one cell of a row of cells: (cell + f) / side with f, [0, 1), the upper 53 bits of the finaliser of SplitMix64.</summary>
    /// <param name="numbers">A number for each place.</param>
    /// <param name="first">Added to all numbers.</param>
    /// <param name="key">Other numbers for the same things: what the sums are combined with, bit by bit.</param>
    /// <param name="cell">The cell.</param>
    /// <param name="side">Number of cells in the row.</param>
    /// <param name="places">Receives the places, [0, 1).</param>
    /// <param name="count">How many; a multiple of 4.</param>
    public static void Jitter(ulong* numbers, ulong first, ulong key, int cell, int side, double* places, int count)
    {
        Vector256<ulong> start = Vector256.Create(first), keys = Vector256.Create(key);
        Vector256<double> cells = Vector256.Create((double)cell), sides = Vector256.Create((double)side);
        for (int i = 0; i < count; i += Width)
        {
            Vector256<ulong> bits = Mix((Vector256.Load(numbers + i) + start) ^ keys) >>> 11;
            ((cells + (ToDouble(bits) * (1.0 / (1UL << 53)))) / sides).Store(places + i);
        }
    }

    /// <summary>A point of Sobol's sequence, scrambled differently for each place: the hash of Burley, "Practical Hash-based Owen Scrambling", 2020.</summary>
    /// <param name="numbers">A number for each place.</param>
    /// <param name="first">Added to all numbers.</param>
    /// <param name="key">What the sums are combined with; the upper 32 bits of the finaliser of SplitMix64 choose the scrambling.</param>
    /// <param name="reversed">The point as a fraction of 32 bits, in reverse.</param>
    /// <param name="places">Receives the places, [0, 1).</param>
    /// <param name="count">How many; a multiple of 4.</param>
    public static void Scramble(ulong* numbers, ulong first, ulong key, uint reversed, double* places, int count)
    {
        Vector256<ulong> start = Vector256.Create(first), keys = Vector256.Create(key);
        for (int i = 0; i < count; i += Width)
        {
            // Of each pair of numbers the lower one counts.
            Vector256<uint> value = (Mix((Vector256.Load(numbers + i) + start) ^ keys) >>> 32).AsUInt32() + Vector256.Create(reversed);
            value ^= value * Vector256.Create(0x6c50b47cu);
            value ^= value * Vector256.Create(0xb82f1e52u);
            value ^= value * Vector256.Create(0xc7afe638u);
            value ^= value * Vector256.Create(0x8d22f6e6u);
            (ToDouble(Reverse(value).AsUInt64() & Vector256.Create((ulong)uint.MaxValue)) * (1.0 / (1L << 32))).Store(places + i);
        }
    }

    private static Vector256<uint> Reverse(Vector256<uint> number)
    {
        number = (number << 16) | (number >>> 16);
        number = Exchange(number, 8, 0x00FF00FF);
        number = Exchange(number, 4, 0x0F0F0F0F);
        number = Exchange(number, 2, 0x33333333);
        return Exchange(number, 1, 0x55555555);
    }

    /// <summary>Neighbouring groups of bits in each other's place.</summary>
    private static Vector256<uint> Exchange(Vector256<uint> number, int bits, uint lower) =>
        ((number & Vector256.Create(lower)) << bits) | ((number >>> bits) & Vector256.Create(lower));

    private static Vector256<ulong> Mix(Vector256<ulong> z)
    {
        z += Vector256.Create(0x9E3779B97F4A7C15);
        z = (z ^ (z >>> 30)) * Vector256.Create(0xBF58476D1CE4E5B9);
        z = (z ^ (z >>> 27)) * Vector256.Create(0x94D049BB133111EB);
        return z ^ (z >>> 31);
    }

    /// <summary>Whole numbers below 2^53 as doubles, exactly: the lower half in the significand of 2^52, the upper one in that of 2^84.</summary>
    private static Vector256<double> ToDouble(Vector256<ulong> number)
    {
        const ulong Double84 = 0x4530_0000_0000_0000;
        Vector256<ulong> low = (number & Vector256.Create((ulong)uint.MaxValue)) | Vector256.Create((ulong)LaneBits.Double52), high = (number >>> 32) | Vector256.Create(Double84);
        return (high.AsDouble() - Vector256.Create(BitConverter.UInt64BitsToDouble(Double84))) + (low.AsDouble() - Vector256.Create(BitConverter.Int64BitsToDouble(LaneBits.Double52)));
    }
}
