using System.Buffers.Binary;

namespace LabRaytracer;

/// <summary>The IHDR chunk of a PNG file, checked.</summary>
internal readonly record struct PngHeader(int Width, int Height, int BitDepth, PngColorType ColorType, bool IsInterlaced)
{
    /// <summary>Samples a pixel in the file.</summary>
    public int Channels => ColorType switch
    {
        PngColorType.Rgb => 3,
        PngColorType.GreyAlpha => 2,
        PngColorType.Rgba => 4,
        _ => 1,
    };

    /// <summary>Distance in bytes that filters look back: a pixel, at least 1.</summary>
    public int FilterDistance => Math.Max(1, Channels * BitDepth / 8);

    /// <summary>Bytes of a row of some pixels, without the filter byte.</summary>
    public int RowBytes(int width) => (int)((((long)width * Channels * BitDepth) + 7) / 8);

    /// <summary>Reads the chunk's content.</summary>
    /// <exception cref="PictureFormatException">Something in it is not allowed.</exception>
    public static PngHeader Parse(ReadOnlySpan<byte> content, PictureLimits limits, string name)
    {
        if (content.Length != 13)
        {
            throw new PictureFormatException(name, $"the IHDR chunk has {content.Length} bytes instead of 13");
        }

        uint width = BinaryPrimitives.ReadUInt32BigEndian(content);
        uint height = BinaryPrimitives.ReadUInt32BigEndian(content[4..]);
        limits.Check(width, height, name);
        int bitDepth = content[8];
        PngColorType colorType = (PngColorType)content[9];
        bool allowed = colorType switch
        {
            PngColorType.Grey => bitDepth is 1 or 2 or 4 or 8 or 16,
            PngColorType.Palette => bitDepth is 1 or 2 or 4 or 8,
            PngColorType.Rgb or PngColorType.GreyAlpha or PngColorType.Rgba => bitDepth is 8 or 16,
            _ => false,
        };
        if (!allowed)
        {
            throw new PictureFormatException(name, $"colour type {content[9]} with bit depth {bitDepth} does not exist in PNG");
        }

        if (content[10] != 0 || content[11] != 0 || content[12] > 1)
        {
            throw new PictureFormatException(
                name,
                $"compression {content[10]}, filter {content[11]} or interlace {content[12]} is not known; allowed are 0, 0 and 0 or 1");
        }

        return new PngHeader((int)width, (int)height, bitDepth, colorType, content[12] == 1);
    }
}
