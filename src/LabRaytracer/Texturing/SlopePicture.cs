namespace LabRaytracer;

/// <summary>Turns a picture of heights into one of slopes, which then is filtered as any other: the slope of a mean height is the mean slope.</summary>
/// <remarks>
/// Red is dh/du, green is dh/dv, blue is h: half the difference of both neighbours of a texel, times texels in one unit of u or v. 16 bytes a texel.
/// A border counts as the edge texel going on: heights do not fall off a cliff there.
/// </remarks>
internal static class SlopePicture
{
    /// <summary>The slopes of a picture.</summary>
    /// <param name="store">The heights, packed.</param>
    /// <param name="channel">Which channel.</param>
    /// <param name="options">How the picture is looked up: wraps and texel convention.</param>
    /// <param name="wrapU">Wrap in u where the options have none.</param>
    /// <param name="wrapV">Wrap in v where the options have none.</param>
    public static TexelStore Create(TexelStore store, TextureChannel channel, SamplingOptions options, TextureWrap wrapU, TextureWrap wrapV)
    {
        int width = store.Width, height = store.Height;
        float[] heights = Heights(store, channel, options.ColorSpace);
        float[] slopes = new float[4 * width * height];
        int lost = options.Texels == TexelConvention.Lab ? 1 : 0;
        float perU = 0.5f * (width - lost), perV = 0.5f * (height - lost);
        TextureWrap inU = options.WrapU ?? wrapU, inV = options.WrapV ?? wrapV;
        Parallel.For(0, height, y =>
        {
            int above = Neighbor(y + 1, height, inV) * width, below = Neighbor(y - 1, height, inV) * width;
            for (int x = 0; x < width; x++)
            {
                // Rows of pixel buffers go down.
                int at = 4 * (((height - 1 - y) * width) + x);
                slopes[at] = (heights[(y * width) + Neighbor(x + 1, width, inU)] - heights[(y * width) + Neighbor(x - 1, width, inU)]) * perU;
                slopes[at + 1] = (heights[above + x] - heights[below + x]) * perV;
                slopes[at + 2] = heights[(y * width) + x];
                slopes[at + 3] = 1;
            }
        });
        return new TexelStore(PixelBuffer.FromRgbaFloat(width, height, slopes, TransferFunction.Linear, "slopes"));
    }

    private static float[] Heights(TexelStore store, TextureChannel channel, ColorSpace colorSpace)
    {
        float[] heights = new float[store.Width * store.Height];
        Parallel.For(0, store.Height, y =>
        {
            ReadOnlySpan<float> table = PictureSamplers.DecodeTable(store, isData: true, colorSpace);
            for (int x = 0; x < store.Width; x++)
            {
                Intensity color = store.Color(table, x, y);
                heights[(y * store.Width) + x] = channel switch
                {
                    TextureChannel.Red => color.R,
                    TextureChannel.Green => color.G,
                    TextureChannel.Blue => color.B,
                    TextureChannel.Alpha => store.Alpha(x, y),
                    _ => color.Luminance,
                };
            }
        });
        return heights;
    }

    /// <summary>The texel that stands for one beside the picture.</summary>
    private static int Neighbor(int texel, int size, TextureWrap wrap) => wrap switch
    {
        TextureWrap.Repeat => (texel + size) % size,
        _ => Math.Clamp(texel, 0, size - 1),
    };
}
