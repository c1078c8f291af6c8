namespace LabRaytracer.Validation;

/// <summary>sRGB both ways against the exact curve: every code, and the floats beside every threshold.</summary>
internal sealed class ColorSweep(StressOptions options)
{
    /// <summary>All lines of the table.</summary>
    public IEnumerable<StressRow> Run() => [Decode(255, 1), Encode(255, 1), Decode(65535, options.IsLong ? 1 : 64), Encode(65535, options.IsLong ? 1 : 64)];

    private StressRow Decode(int max, int stride)
    {
        Worst worst = new($"sRGB decode, {Bits(max)} bit: not the nearest float", 0, "");
        Parallel.For(0, Count(max, stride), i =>
        {
            int code = Code(i, max, stride);
            float found = max == 255 ? ColorEncoding.LinearFromSrgb8((byte)code) : ColorEncoding.LinearFromSrgb16((ushort)code);
            worst.Count(found == Truth.Nearest(Truth.SrgbDecode((Real)code / max), true), $"code {code}: {found:R}");
        });
        return worst.ToRow();
    }

    private StressRow Encode(int max, int stride)
    {
        Worst worst = new($"sRGB encode, {Bits(max)} bit: wrong codes beside thresholds", 0, "");
        Parallel.For(0, Count(max, stride), i =>
        {
            // Code k begins at the light of (k - 1/2) / max.
            int code = Math.Max(1, Code(i, max, stride));
            Real threshold = Truth.SrgbDecode(((Real)code - 0.5) / max);
            float nearest = (float)Truth.Nearest(threshold, true);
            foreach (float light in new[] { MathF.BitDecrement(nearest), nearest, MathF.BitIncrement(nearest) })
            {
                int found = max == 255 ? ColorEncoding.Srgb8FromLinear(light) : ColorEncoding.Srgb16FromLinear(light);
                worst.Count(found == (light >= threshold ? code : code - 1), $"light {light:R}: code {found}");
            }
        });
        return worst.ToRow();
    }

    private static int Bits(int max) => max == 255 ? 8 : 16;

    private static int Count(int max, int stride) => (max / stride) + 1;

    /// <summary>Every code in the long form; else a choice of each part of the curve that the seed shifts.</summary>
    private int Code(int i, int max, int stride) => Math.Min(max, (i * stride) + (int)(options.Seed % (ulong)stride));
}
