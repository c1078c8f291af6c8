namespace LabRaytracer;

/// <summary>Exactly rounded encoding of light to codes: a start from the top bits of the float, then comparisons with the exact thresholds.</summary>
internal sealed class CodeTable
{
    private readonly int maxCode;
    private readonly int shift;
    private readonly int firstBits;

    // thresholds[k] is the smallest float that gets code k; one more entry that nothing reaches.
    private readonly float[] thresholds;

    // starts[i] is the code of the smallest float of bucket i.
    private readonly ushort[] starts;

    /// <summary>Builds the table of a transfer function for codes 0..maxCode (255 or 65535).</summary>
    public CodeTable(TransferFunction transfer, int maxCode)
    {
        this.maxCode = maxCode;

        // 128 or 1024 buckets an octave: an 8-bit sRGB bucket then holds one threshold at most.
        shift = maxCode > 255 ? 13 : 16;
        thresholds = new float[maxCode + 2];
        thresholds[0] = float.NegativeInfinity;
        thresholds[maxCode + 1] = float.PositiveInfinity;
        for (int code = 1; code <= maxCode; code++)
        {
            thresholds[code] = RoundUp(transfer.Decode((code - 0.5) / maxCode));
        }

        firstBits = BitConverter.SingleToInt32Bits(thresholds[1]) >> shift << shift;
        int buckets = ((BitConverter.SingleToInt32Bits(thresholds[maxCode]) - firstBits) >> shift) + 2;
        starts = new ushort[buckets];
        int start = 0;
        for (int bucket = 0; bucket < buckets; bucket++)
        {
            float lowest = BitConverter.Int32BitsToSingle(firstBits + (bucket << shift));
            while (thresholds[start + 1] <= lowest)
            {
                start++;
            }

            starts[bucket] = (ushort)start;
        }
    }

    /// <summary>The code of a light, for tables with few thresholds in a bucket.</summary>
    public int Encode8(float light)
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

        int code = starts[(BitConverter.SingleToInt32Bits(light) - firstBits) >> shift];
        code += light >= table[code + 1] ? 1 : 0;
        while (light >= table[code + 1])
        {
            code++;
        }

        return code;
    }

    /// <summary>The code of a light, for tables with many thresholds in a bucket: linear interpolation guesses, comparison decides.</summary>
    public int Encode16(float light)
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
        int rest = offset & ((1 << shift) - 1);
        int code = starts[bucket] + (((starts[bucket + 1] - starts[bucket]) * rest) >> shift);
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
