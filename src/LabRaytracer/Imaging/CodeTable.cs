namespace LabRaytracer;

/// <summary>Exactly rounded encoding of light to codes: interpolation in the bits of the float guesses, comparison with exact thresholds decides.</summary>
/// <remarks>Immutable, thread safe.</remarks>
internal sealed class CodeTable
{
    private readonly int maxCode;
    private readonly int shift;
    private readonly int firstBits;

    // thresholds[k] is the smallest float that gets code k; one more entry that nothing reaches.
    private readonly float[] thresholds;

    // guesses[i] is the code of the smallest float of bucket i, not rounded, plus 1/2, in steps of 2^-16.
    private readonly uint[] guesses;

    /// <summary>Builds the table of a transfer function for codes 0..maxCode (255 or 65535).</summary>
    public CodeTable(TransferFunction transfer, int maxCode)
    {
        this.maxCode = maxCode;
        thresholds = new float[maxCode + 2];
        thresholds[0] = float.NegativeInfinity;
        thresholds[maxCode + 1] = float.PositiveInfinity;
        for (int code = 1; code <= maxCode; code++)
        {
            thresholds[code] = RoundUp(transfer.Decode((code - 0.5) / maxCode));
        }

        // 128 or 1024 buckets an octave: a straight line is then within 1/200 of a code of the sRGB curve, and a guess is seldom wrong.
        shift = maxCode > 255 ? 13 : 16;
        firstBits = BitConverter.SingleToInt32Bits(thresholds[1]) >> shift << shift;
        guesses = new uint[((BitConverter.SingleToInt32Bits(thresholds[maxCode]) - firstBits) >> shift) + 2];
        for (int bucket = 0; bucket < guesses.Length; bucket++)
        {
            double lowest = BitConverter.Int32BitsToSingle(firstBits + (bucket << shift));
            guesses[bucket] = (uint)(((Math.Min(transfer.Encode(lowest), 1) * maxCode) + 0.5) * 65536);
        }
    }

    /// <summary>The code whose interval holds a light; 0 for NaN and negative light, the largest above 1.</summary>
    public int Encode(float light)
    {
        float[] table = thresholds;
        if (!(light >= table[1]))
        {
            return 0;
        }

        if (light >= table[maxCode])
        {
            return maxCode;
        }

        int offset = BitConverter.SingleToInt32Bits(light) - firstBits;
        int bucket = offset >> shift;
        ulong rest = (uint)offset & ((1u << shift) - 1);
        uint guess = guesses[bucket] + (uint)(((guesses[bucket + 1] - guesses[bucket]) * rest) >> shift);
        int code = (int)(guess >> 16);
        while (light >= table[code + 1])
        {
            code++;
        }

        while (light < table[code])
        {
            code--;
        }

        return code;
    }

    /// <summary>The smallest float that is not below a value.</summary>
    private static float RoundUp(double value)
    {
        float nearest = (float)value;
        return nearest < value ? MathF.BitIncrement(nearest) : nearest;
    }
}
