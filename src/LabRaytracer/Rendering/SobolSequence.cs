namespace LabRaytracer;

/// <summary>The points of <see cref="SquareSequence"/>, scrambled more thoroughly than by exclusive-or: errors of edges then average out faster.</summary>
internal static class SobolSequence
{
    /// <summary>2^-32.</summary>
    public const double Unit = 1.0 / (1L << 32);

    /// <summary>Owen's scrambling by a hash in which a digit depends on higher digits only: Burley, "Practical Hash-based Owen Scrambling", 2020.</summary>
    /// <param name="value">Digits in base 2.</param>
    /// <param name="seed">Chooses the scrambling.</param>
    public static uint Scramble(uint value, uint seed) => ScrambleReversed(Reversed(value), seed);

    /// <summary>The bits of a number in reverse: the first coordinate of the sequence.</summary>
    public static uint Reversed(uint value) => SquareSequence.First(value);

    /// <summary>The same of a number whose bits are in reverse.</summary>
    public static uint ScrambleReversed(uint value, uint seed)
    {
        value += seed;
        value ^= value * 0x6c50b47c;
        value ^= value * 0xb82f1e52;
        value ^= value * 0xc7afe638;
        value ^= value * 0x8d22f6e6;
        return Reversed(value);
    }
}
