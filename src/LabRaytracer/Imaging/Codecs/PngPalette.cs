using System.Buffers.Binary;

namespace LabRaytracer;

/// <summary>The PLTE and tRNS chunks of a PNG file: colours of indices, transparency of colours.</summary>
internal sealed class PngPalette(PngHeader header, string name)
{
    private byte[]? colors;
    private byte[]? transparency;

    /// <summary>Whether there is a palette.</summary>
    public bool HasColors => colors is not null;

    /// <summary>The colour that is transparent, 16-bit samples as in the file; null if there is none.</summary>
    public (ushort R, ushort G, ushort B)? TransparentColor { get; private set; }

    /// <summary>Takes the content of the PLTE chunk.</summary>
    public void AddColors(byte[] content)
    {
        if (colors is not null || transparency is not null || header.ColorType is PngColorType.Grey or PngColorType.GreyAlpha)
        {
            throw Bad("the PLTE chunk is doubled, behind tRNS or in a grey picture");
        }

        int most = header.ColorType == PngColorType.Palette ? 1 << header.BitDepth : 256;
        if (content.Length == 0 || content.Length % 3 != 0 || content.Length > 3 * most)
        {
            throw Bad($"the PLTE chunk has {content.Length} bytes; a multiple of 3 in [3, {3 * most}] is allowed");
        }

        colors = content;
    }

    /// <summary>Takes the content of the tRNS chunk.</summary>
    public void AddTransparency(byte[] content)
    {
        bool good = transparency is null && header.ColorType switch
        {
            PngColorType.Grey => content.Length == 2,
            PngColorType.Rgb => content.Length == 6,
            PngColorType.Palette => colors is not null && content.Length >= 1 && content.Length <= colors.Length / 3,
            _ => false,
        };
        if (!good)
        {
            throw Bad("the tRNS chunk is doubled, has a wrong length, or is not allowed there");
        }

        transparency = content;
        if (header.ColorType != PngColorType.Palette)
        {
            ushort red = BinaryPrimitives.ReadUInt16BigEndian(content);
            TransparentColor = content.Length == 2
                ? (red, red, red)
                : (red, BinaryPrimitives.ReadUInt16BigEndian(content.AsSpan(2)), BinaryPrimitives.ReadUInt16BigEndian(content.AsSpan(4)));
        }
    }

    /// <summary>RGBA of every sample value of a grey or palette picture of at most 8 bits; shorter than 2^BitDepth if the palette is.</summary>
    public byte[] CreateLookup()
    {
        return header.ColorType == PngColorType.Palette ? PaletteLookup() : GreyLookup();
    }

    private byte[] PaletteLookup()
    {
        byte[] source = colors ?? throw Bad("the palette (PLTE chunk) is missing");
        byte[] lookup = new byte[source.Length / 3 * 4];
        for (int i = 0; i < source.Length / 3; i++)
        {
            source.AsSpan(3 * i, 3).CopyTo(lookup.AsSpan(4 * i));
            lookup[(4 * i) + 3] = i < (transparency?.Length ?? 0) ? transparency![i] : (byte)255;
        }

        return lookup;
    }

    private byte[] GreyLookup()
    {
        int count = 1 << header.BitDepth;
        byte[] lookup = new byte[4 * count];
        for (int value = 0; value < count; value++)
        {
            // 255 is a multiple of 1, 3, 15 and 255: exact.
            lookup.AsSpan(4 * value, 3).Fill((byte)(value * (255 / (count - 1))));
            lookup[(4 * value) + 3] = TransparentColor is { } clear && clear.R == value ? (byte)0 : (byte)255;
        }

        return lookup;
    }

    private PictureFormatException Bad(string reason) => new(name, reason);
}
