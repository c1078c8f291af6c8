namespace LabRaytracer;

/// <summary>The points of <see cref="SquareSequence"/>, scrambled more thoroughly than by exclusive-or: errors of edges then average out faster.</summary>
internal static class SobolSequence
{
    private const double Unit = 1.0 / (1L << 32);

    /// <summary>A point's coordinate, [0, 1).</summary>
    /// <param name="number">Number of the point.</param>
    /// <param name="axis">0 or 1.</param>
    /// <param name="scramble">Chooses the scrambling.</param>
    public static double At(uint number, int axis, uint scramble) =>
        Unit * Scramble(axis == 0 ? SquareSequence.First(number) : SquareSequence.Second(number), scramble);

    /// <summary>Owen's scrambling by a hash in which a digit depends on higher digits only: Burley, "Practical Hash-based Owen Scrambling", 2020.</summary>
    /// <param name="value">Digits in base 2.</param>
    /// <param name="seed">Chooses the scrambling.</param>
    public static uint Scramble(uint value, uint seed)
    {
        // The first coordinate of the sequence is its argument with the bits in reverse.
        value = SquareSequence.First(value) + seed;
        value ^= value * 0x6c50b47c;
        value ^= value * 0xb82f1e52;
        value ^= value * 0xc7afe638;
        value ^= value * 0x8d22f6e6;
        return SquareSequence.First(value);
    }
}
