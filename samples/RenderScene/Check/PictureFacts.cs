using LabRaytracer;

namespace RenderScene;

/// <summary>What can be told of a picture file by its numbers, 0 to 1.</summary>
internal sealed class PictureFacts
{
    private readonly PixelBuffer _pixels;

    /// <param name="path">The file.</param>
    /// <exception cref="PictureFormatException">It is no picture.</exception>
    public PictureFacts(string path) => _pixels = PictureCodecs.Default.Read(path, null);

    /// <summary>Columns.</summary>
    public int Width => _pixels.Width;

    /// <summary>Rows.</summary>
    public int Height => _pixels.Height;

    /// <summary>What the file says about its colours and nobody does; null if nothing is left undone.</summary>
    public string? ColorDoubt => _pixels.TransferSource is { } source && source.Contains(" not ", StringComparison.Ordinal) ? source : null;

    /// <summary>Tells whether some texel is not opaque.</summary>
    public bool HasAlpha => _pixels.HasAlpha;

    /// <summary>Tells whether the picture is grey throughout.</summary>
    public bool IsGrey => _pixels.IsGrey;

    /// <summary>Mean of each channel.</summary>
    public Intensity Mean
    {
        get
        {
            double red = 0, green = 0, blue = 0;
            for (int texel = 0; texel < Width * Height; texel++)
            {
                red += At(texel, 0);
                green += At(texel, 1);
                blue += At(texel, 2);
            }

            double share = 1.0 / ((double)Width * Height);
            return new Intensity((float)(red * share), (float)(green * share), (float)(blue * share));
        }
    }

    /// <summary>Tells whether the picture has the colour of normal maps: blue, red and green around one half.</summary>
    public bool LooksLikeNormals
    {
        get
        {
            Intensity mean = Mean;
            return !IsGrey && mean.B > 0.7f && Math.Abs(mean.R - 0.5f) < 0.1f && Math.Abs(mean.G - 0.5f) < 0.1f;
        }
    }

    /// <summary>Mean difference of codes between the right column and the left one, and the largest between columns inside, 0 to 255.</summary>
    public (double AtEdges, double Inside) SeamSteps()
    {
        double inside = 0;
        for (int x = 1; x < Width; x++)
        {
            inside = Math.Max(inside, Step(x - 1, x));
        }

        return (Step(Width - 1, 0), inside);
    }

    /// <summary>
    /// How well the normals are those of a surface, with green up and with green down: mean square of the curl of the slopes, which is 0 for every surface of heights.
    /// </summary>
    public (double Up, double Down) Curls()
    {
        double up = 0, down = 0;
        for (int y = 0; y + 1 < Height; y++)
        {
            for (int x = 0; x + 1 < Width; x++)
            {
                int texel = (y * Width) + x;

                // Slopes -x/z and -y/z; rows go down, so v grows towards the row above.
                double across = Slope(texel, 0) - Slope(texel + Width, 0), along = Slope(texel + 1, 1) - Slope(texel, 1);
                up += (across - along) * (across - along);
                down += (across + along) * (across + along);
            }
        }

        return (up, down);
    }

    private double Slope(int texel, int channel) => -((2 * At(texel, channel)) - 1) / Math.Max((2 * At(texel, 2)) - 1, 0.05);

    /// <summary>Mean difference of two columns.</summary>
    private double Step(int left, int right)
    {
        double sum = 0;
        for (int row = 0; row < Height; row++)
        {
            sum += TexelStep((row * Width) + left, (row * Width) + right);
        }

        return sum / Height;
    }

    private double TexelStep(int a, int b) => 255 * (Math.Abs(At(a, 0) - At(b, 0)) + Math.Abs(At(a, 1) - At(b, 1)) + Math.Abs(At(a, 2) - At(b, 2))) / 3;

    private double At(int texel, int channel) =>
        _pixels.Rgba8 is { } bytes ? bytes[(4 * texel) + channel] / 255.0
        : _pixels.Rgba16 is { } words ? words[(4 * texel) + channel] / 65535.0
        : _pixels.RgbaFloat![(4 * texel) + channel];
}
