namespace LabRaytracer;

/// <summary>A picture of linear RGB light in floats; row 0 is the top row.</summary>
/// <remarks>Values are neither clamped nor encoded. Reading from several threads is safe, and so is writing different pixels.</remarks>
public sealed class Picture
{
    private readonly Intensity[] pixels;

    /// <summary>Makes a black picture.</summary>
    /// <param name="width">Columns, in [1, 1048576].</param>
    /// <param name="height">Rows, in [1, 1048576].</param>
    /// <exception cref="ArgumentOutOfRangeException">A side is outside of its range, or there are more than 2^29 pixels.</exception>
    public Picture(int width, int height)
    {
        PictureSize.Check(width, height);
        (Width, Height) = (width, height);
        pixels = new Intensity[width * height];
    }

    private Picture(int width, int height, Intensity[] pixels) => (Width, Height, this.pixels) = (width, height, pixels);

    /// <summary>Columns, in [1, 1048576].</summary>
    public int Width { get; }

    /// <summary>Rows, in [1, 1048576].</summary>
    public int Height { get; }

    /// <summary>All pixels, row by row from the top.</summary>
    public Span<Intensity> Pixels => pixels;

    /// <summary>All pixels, for work on other threads.</summary>
    internal ReadOnlyMemory<Intensity> Memory => pixels;

    /// <summary>One pixel.</summary>
    /// <param name="x">Column, [0, Width), from the left.</param>
    /// <param name="y">Row, [0, Height), from the top.</param>
    /// <exception cref="ArgumentOutOfRangeException">There is no such pixel.</exception>
    public Intensity this[int x, int y]
    {
        get => pixels[IndexOf(x, y)];
        set => pixels[IndexOf(x, y)] = value;
    }

    /// <summary>Reads a picture file of any known format, recognised by its content.</summary>
    /// <param name="path">The file.</param>
    /// <param name="limits">What is refused; null for the defaults.</param>
    /// <exception cref="PictureFormatException">The content is damaged, unknown or over a limit.</exception>
    /// <exception cref="IOException">The file cannot be read.</exception>
    public static Picture Load(string path, PictureLimits? limits = null) => FromPixels(PictureCodecs.Default.Read(path, limits));

    /// <summary>Decodes stored samples to linear light; alpha is left out, colours stay as stored.</summary>
    /// <param name="buffer">The samples.</param>
    public static Picture FromPixels(PixelBuffer buffer)
    {
        ArgumentNullException.ThrowIfNull(buffer);
        var picture = new Picture(buffer.Width, buffer.Height);
        PixelDecoder.Decode(buffer, picture.pixels);
        return picture;
    }

    /// <summary>Makes a picture of which every pixel will be written before it is read.</summary>
    /// <param name="width">Columns, in [1, 1048576].</param>
    /// <param name="height">Rows, in [1, 1048576].</param>
    internal static Picture Unwritten(int width, int height)
    {
        PictureSize.Check(width, height);
        return new Picture(width, height, GC.AllocateUninitializedArray<Intensity>(width * height));
    }

    /// <summary>One row, to read or write.</summary>
    /// <param name="y">Row, [0, Height), from the top.</param>
    /// <exception cref="ArgumentOutOfRangeException">There is no such row.</exception>
    public Span<Intensity> Row(int y)
    {
        ArgumentOutOfRangeException.ThrowIfNegative(y);
        ArgumentOutOfRangeException.ThrowIfGreaterThanOrEqual(y, Height);
        return pixels.AsSpan(y * Width, Width);
    }

    /// <summary>Writes the picture; the extension chooses the format.</summary>
    /// <param name="path">Target. It is replaced only when the new file is complete; on failure the old one stays as it was.</param>
    /// <param name="options">How; null for the defaults.</param>
    /// <exception cref="ArgumentException">No codec writes files with this extension.</exception>
    /// <exception cref="IOException">The target cannot be written.</exception>
    public void Save(string path, PictureSaveOptions? options = null) => PictureCodecs.Default.Write(this, path, options);

    private int IndexOf(int x, int y)
    {
        if ((uint)x >= (uint)Width || (uint)y >= (uint)Height)
        {
            throw new ArgumentOutOfRangeException(
                (uint)x >= (uint)Width ? nameof(x) : nameof(y),
                $"There is no pixel ({x}, {y}): x must be in [0, {Width}) and y in [0, {Height}).");
        }

        return (y * Width) + x;
    }
}
