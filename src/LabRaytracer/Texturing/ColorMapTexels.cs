namespace LabRaytracer;

/// <summary>Between the array of a <see cref="Texture"/>, row 0 at the bottom, and packed texels, row 0 on top.</summary>
internal static class ColorMapTexels
{
    /// <summary>The colours of packed texels as an array.</summary>
    /// <param name="store">The texels.</param>
    /// <param name="table">Linear light of every code; empty for float samples.</param>
    public static Intensity[,] Unpack(TexelStore store, ReadOnlySpan<float> table)
    {
        Intensity[,] colorMap = new Intensity[store.Width, store.Height];
        for (int y = 0; y < store.Height; y++)
        {
            for (int x = 0; x < store.Width; x++)
            {
                colorMap[x, y] = store.Color(table, x, y);
            }
        }

        return colorMap;
    }

    /// <summary>An array as packed floats.</summary>
    /// <param name="colorMap">Colours, [x, y].</param>
    /// <param name="alpha">Alpha of a texel, by x and y.</param>
    public static TexelStore Pack(Intensity[,] colorMap, Func<int, int, float> alpha)
    {
        int width = colorMap.GetLength(0), height = colorMap.GetLength(1);
        float[] samples = new float[4 * width * height];
        for (int x = 0; x < width; x++)
        {
            for (int y = 0; y < height; y++)
            {
                Intensity color = colorMap[x, y];
                int at = 4 * (((height - 1 - y) * width) + x);
                (samples[at], samples[at + 1], samples[at + 2], samples[at + 3]) = (color.R, color.G, color.B, alpha(x, y));
            }
        }

        return new TexelStore(PixelBuffer.FromRgbaFloat(width, height, samples, TransferFunction.Linear, "ColorMap"));
    }
}
