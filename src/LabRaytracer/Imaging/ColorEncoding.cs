namespace LabRaytracer;

/// <summary>Between linear light and stored codes: the only sRGB of the library.</summary>
/// <remarks>
/// sRGB is the piecewise curve of IEC 61966-2-1. Codes are exactly rounded: a value gets the code k with decode((k - 1/2)/max) at most the
/// value and decode((k + 1/2)/max) above it. NaN and negative light give code 0, light above 1 the largest. Thread safe, the same bits everywhere.
/// </remarks>
public static class ColorEncoding
{
    private static readonly float[] SrgbDecode8 = CreateTable(TransferFunction.Srgb, 255);
    private static readonly Lazy<float[]> SrgbDecode16 = new(() => CreateTable(TransferFunction.Srgb, 65535));
    private static readonly CodeTable SrgbEncode8 = new(TransferFunction.Srgb, 255);
    private static readonly Lazy<CodeTable> SrgbEncode16 = new(() => new CodeTable(TransferFunction.Srgb, 65535));

    /// <summary>Linear light of an 8-bit sRGB code, [0, 1]: the float nearest to the exact value.</summary>
    /// <param name="code">The code, 0..255.</param>
    public static float LinearFromSrgb8(byte code) => SrgbDecode8[code];

    /// <summary>Linear light of a 16-bit sRGB code, [0, 1]: the float nearest to the exact value.</summary>
    /// <param name="code">The code, 0..65535.</param>
    public static float LinearFromSrgb16(ushort code) => SrgbDecode16.Value[code];

    /// <summary>Linear light of an sRGB value; not for loops over pixels.</summary>
    /// <param name="encoded">1 is display white; below 0 and NaN give 0; above 1 the curve goes on.</param>
    public static float LinearFromSrgb(float encoded) => (float)TransferFunction.Srgb.Decode(encoded);

    /// <summary>sRGB value of linear light, not rounded to a code; not for loops over pixels.</summary>
    /// <param name="light">1 is display white; below 0 and NaN give 0; above 1 the curve goes on.</param>
    public static float SrgbFromLinear(float light) => (float)TransferFunction.Srgb.Encode(light);

    /// <summary>The 8-bit sRGB code whose interval holds the light, 0..255.</summary>
    /// <param name="light">Linear light; clamped to [0, 1], NaN gives 0.</param>
    public static byte Srgb8FromLinear(float light) => (byte)SrgbEncode8.Encode(light);

    /// <summary>The 16-bit sRGB code whose interval holds the light, 0..65535.</summary>
    /// <param name="light">Linear light; clamped to [0, 1], NaN gives 0.</param>
    public static ushort Srgb16FromLinear(float light) => (ushort)SrgbEncode16.Value.Encode(light);

    /// <summary>The linear 8-bit code floor(255 light + 1/2), 0..255.</summary>
    /// <param name="light">Linear light; clamped to [0, 1], NaN gives 0.</param>
    public static byte Linear8FromLinear(float light) => (byte)LinearCode(light, 255);

    /// <summary>The linear 16-bit code floor(65535 light + 1/2), 0..65535.</summary>
    /// <param name="light">Linear light; clamped to [0, 1], NaN gives 0.</param>
    public static ushort Linear16FromLinear(float light) => (ushort)LinearCode(light, 65535);

    /// <summary>Linear light of every code: 256 floats for <see cref="PixelFormat.Rgba8"/>, 65536 for <see cref="PixelFormat.Rgba16"/>.</summary>
    /// <param name="transfer">What the codes mean.</param>
    /// <param name="format">Rgba8 or Rgba16.</param>
    /// <exception cref="ArgumentException">The format has no codes.</exception>
    public static ReadOnlySpan<float> DecodeTable(TransferFunction transfer, PixelFormat format) => format switch
    {
        PixelFormat.Rgba8 => transfer.IsSrgb ? SrgbDecode8 : CreateTable(transfer, 255),
        PixelFormat.Rgba16 => transfer.IsSrgb ? SrgbDecode16.Value : CreateTable(transfer, 65535),
        _ => throw new ArgumentException("Float samples have no table of codes; allowed are Rgba8 and Rgba16.", nameof(format)),
    };

    /// <summary>The table that encodes light for a bit depth of 8 or 16; null when the codes are linear.</summary>
    internal static CodeTable? EncodeTable(TransferFunction transfer, int bitDepth)
    {
        if (transfer.IsLinear)
        {
            return null;
        }

        if (transfer.IsSrgb)
        {
            return bitDepth == 8 ? SrgbEncode8 : SrgbEncode16.Value;
        }

        return new CodeTable(transfer, bitDepth == 8 ? 255 : 65535);
    }

    /// <summary>floor(max * light + 1/2), clamped; the product is exact in double, so the code is exactly rounded.</summary>
    internal static int LinearCode(float light, int max)
    {
        if (!(light > 0))
        {
            return 0;
        }

        return light >= 1 ? max : (int)(((double)light * max) + 0.5);
    }

    private static float[] CreateTable(TransferFunction transfer, int max)
    {
        float[] table = new float[max + 1];
        for (int code = 0; code <= max; code++)
        {
            table[code] = (float)transfer.Decode((double)code / max);
        }

        return table;
    }
}
