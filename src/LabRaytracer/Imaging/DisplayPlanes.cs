namespace LabRaytracer;

/// <summary>A picture as a display shows it: clamped, sRGB encoded with 16 bits, scaled to [0, 1].</summary>
internal sealed class DisplayPlanes
{
    private readonly Intensity[] values;

    /// <summary>Encodes a picture.</summary>
    public DisplayPlanes(Picture picture)
    {
        (Width, Height) = (picture.Width, picture.Height);
        values = new Intensity[Width * Height];
        ReadOnlySpan<Intensity> pixels = picture.Pixels;
        for (int i = 0; i < values.Length; i++)
        {
            values[i] = new Intensity(Display(pixels[i].R), Display(pixels[i].G), Display(pixels[i].B));
        }
    }

    /// <summary>Columns.</summary>
    public int Width { get; }

    /// <summary>Rows.</summary>
    public int Height { get; }

    /// <summary>Displayed value of a pixel, components in [0, 1].</summary>
    public Intensity this[int x, int y] => values[(y * Width) + x];

    /// <summary>Luma of a pixel, [0, 1]: the Rec. 709 weights on encoded values.</summary>
    public double Luma(int x, int y) => this[x, y].Luminance;

    private static float Display(float light) => ColorEncoding.Srgb16FromLinear(light) / 65535f;
}
