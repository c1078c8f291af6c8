namespace LabRaytracer;

/// <summary>Stored samples to linear light, whole buffers at a time.</summary>
internal static class PixelDecoder
{
    /// <summary>Decodes the colours of every pixel; alpha is left out.</summary>
    public static void Decode(PixelBuffer buffer, Span<Intensity> target)
    {
        switch (buffer.Format)
        {
            case PixelFormat.Rgba8:
                Decode8(buffer.Rgba8, ColorEncoding.DecodeTable(buffer.Transfer, PixelFormat.Rgba8), target);
                break;
            case PixelFormat.Rgba16:
                Decode16(buffer.Rgba16, ColorEncoding.DecodeTable(buffer.Transfer, PixelFormat.Rgba16), target);
                break;
            default:
                DecodeFloat(buffer.RgbaFloat, buffer.Transfer, target);
                break;
        }
    }

    private static void Decode8(ReadOnlySpan<byte> samples, ReadOnlySpan<float> table, Span<Intensity> target)
    {
        for (int i = 0; i < target.Length; i++)
        {
            ReadOnlySpan<byte> pixel = samples.Slice(4 * i, 4);
            target[i] = new Intensity(table[pixel[0]], table[pixel[1]], table[pixel[2]]);
        }
    }

    private static void Decode16(ReadOnlySpan<ushort> samples, ReadOnlySpan<float> table, Span<Intensity> target)
    {
        for (int i = 0; i < target.Length; i++)
        {
            ReadOnlySpan<ushort> pixel = samples.Slice(4 * i, 4);
            target[i] = new Intensity(table[pixel[0]], table[pixel[1]], table[pixel[2]]);
        }
    }

    private static void DecodeFloat(ReadOnlySpan<float> samples, TransferFunction transfer, Span<Intensity> target)
    {
        for (int i = 0; i < target.Length; i++)
        {
            ReadOnlySpan<float> pixel = samples.Slice(4 * i, 4);
            target[i] = transfer.IsLinear
                ? new Intensity(pixel[0], pixel[1], pixel[2])
                : new Intensity((float)transfer.Decode(pixel[0]), (float)transfer.Decode(pixel[1]), (float)transfer.Decode(pixel[2]));
        }
    }
}
