namespace LabRaytracer;

/// <summary>What a picture file may ask for; checked from its header, before memory is taken.</summary>
/// <remarks>Immutable, thread safe.</remarks>
public sealed class PictureLimits
{
    private readonly long maxPixels = 64L << 20;
    private readonly int maxSide = PictureSize.MaxSide;
    private readonly int maxChunkBytes = 8 << 20;

    /// <summary>64 Mpixel, 1048576 pixels a side, 8 MB a kept chunk.</summary>
    public static PictureLimits Default { get; } = new();

    /// <summary>Most pixels of a picture, [1, 2^29 - 1]; default 67108864 (64 Mpixel).</summary>
    /// <exception cref="ArgumentOutOfRangeException">The value is outside of its range.</exception>
    public long MaxPixels
    {
        get => maxPixels;
        init => maxPixels = InRange(value, Array.MaxLength / 4);
    }

    /// <summary>Longest side, pixels, [1, 1048576]; default 1048576.</summary>
    /// <exception cref="ArgumentOutOfRangeException">The value is outside of its range.</exception>
    public int MaxSide
    {
        get => maxSide;
        init => maxSide = (int)InRange(value, PictureSize.MaxSide);
    }

    /// <summary>Most bytes of one piece of extra information that is kept while reading (a PNG's ancillary chunk), [1, 2^30]; default 8388608.</summary>
    /// <exception cref="ArgumentOutOfRangeException">The value is outside of its range.</exception>
    public int MaxChunkBytes
    {
        get => maxChunkBytes;
        init => maxChunkBytes = (int)InRange(value, 1 << 30);
    }

    /// <summary>Throws unless a picture of this size is allowed.</summary>
    /// <param name="width">Columns as the file says.</param>
    /// <param name="height">Rows as the file says.</param>
    /// <param name="name">The file's name, for the message.</param>
    /// <exception cref="PictureFormatException">A side is below 1 or above <see cref="MaxSide"/>, or there are more than <see cref="MaxPixels"/>.</exception>
    public void Check(long width, long height, string name)
    {
        if (width < 1 || height < 1)
        {
            throw new PictureFormatException(name, $"the size {width} x {height} is not possible; both sides must be at least 1");
        }

        if (width > MaxSide || height > MaxSide)
        {
            throw new PictureFormatException(name, $"the size {width} x {height} is over the limit of {MaxSide} pixels a side (PictureLimits.MaxSide)");
        }

        if (width * height > MaxPixels)
        {
            throw new PictureFormatException(name, $"the size {width} x {height} is over the limit of {MaxPixels} pixels (PictureLimits.MaxPixels)");
        }
    }

    private static long InRange(long value, long max)
    {
        return value >= 1 && value <= max
            ? value
            : throw new ArgumentOutOfRangeException(nameof(value), value, $"The limit must be in [1, {max}].");
    }
}
