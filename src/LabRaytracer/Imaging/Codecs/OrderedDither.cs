namespace LabRaytracer;

/// <summary>Ordered dither of light to codes of 8 bits: one of the two codes around it, by a threshold that depends on the pixel.</summary>
/// <remarks>
/// B. E. Bayer, "An optimum method for two-level rendition of continuous-tone pictures", 1973: thresholds (k + 1/2) / 64 of an 8 x 8 matrix. What is compared is linear
/// light, not codes, so that the mean light is kept. All three components of a pixel have the same threshold, which keeps greys grey. The thresholds of blue noise
/// are those of <see cref="BlueNoiseMask"/>. Immutable, thread safe.
/// </remarks>
internal sealed class OrderedDither(TransferFunction transfer, Dithering dithering)
{
    /// <summary>Rows and columns after which the thresholds repeat.</summary>
    public const int Side = 8;

    private readonly float[] light = [.. ColorEncoding.DecodeTable(transfer, PixelFormat.Rgba8)];
    private readonly CodeTable? table = ColorEncoding.EncodeTable(transfer, 8);

    /// <summary>The threshold of a pixel of this dither, in (0, 1).</summary>
    /// <param name="x">Column, at least 0.</param>
    /// <param name="y">Row, at least 0.</param>
    public float ThresholdAt(int x, int y) => dithering == Dithering.BlueNoise ? BlueNoiseMask.Threshold(x, y) : Threshold(x, y);

    /// <summary>The threshold of a pixel in Bayer's matrix, in (0, 1).</summary>
    /// <param name="x">Column, at least 0.</param>
    /// <param name="y">Row, at least 0.</param>
    public static float Threshold(int x, int y)
    {
        // The matrix of side 2n has 4 times that of side n, plus 0, 2, 3, 1: bits of x ^ y and y, the lowest one first, interleaved.
        int order = 0;
        for (int bit = 0; bit < 3; bit++)
        {
            order = (order << 2) | ((((x ^ y) >> bit) & 1) << 1) | ((y >> bit) & 1);
        }

        return (order + 0.5f) / (Side * Side);
    }

    /// <summary>The code of one component.</summary>
    /// <param name="value">Light in [0, 1], after tone mapping.</param>
    /// <param name="threshold">The pixel's threshold.</param>
    public byte Code(float value, float threshold)
    {
        int code = table?.Encode(value) ?? ColorEncoding.LinearCode(value, 255);
        code -= value < light[code] ? 1 : 0;
        if (code >= 255)
        {
            return 255;
        }

        float below = light[code], share = (value - below) / (light[code + 1] - below);
        return (byte)(share > threshold ? code + 1 : code);
    }
}
