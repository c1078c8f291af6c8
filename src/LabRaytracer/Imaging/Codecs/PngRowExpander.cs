using System.Buffers.Binary;

namespace LabRaytracer;

/// <summary>Unfiltered rows of a PNG file to four channels.</summary>
internal sealed class PngRowExpander
{
    private readonly PngHeader header;
    private readonly byte[] lookup;
    private readonly (ushort R, ushort G, ushort B)? clear;
    private readonly string name;

    /// <summary>Prepares for a picture.</summary>
    public PngRowExpander(PngHeader header, PngPalette palette, string name)
    {
        (this.header, this.name) = (header, name);
        clear = palette.TransparentColor;
        bool looksUp = header.ColorType == PngColorType.Palette || (header.ColorType == PngColorType.Grey && header.BitDepth <= 8);
        lookup = looksUp ? palette.CreateLookup() : [];
    }

    /// <summary>A row of a picture of at most 8 bits.</summary>
    public void Expand8(ReadOnlySpan<byte> row, Span<byte> target)
    {
        switch (header.ColorType)
        {
            case PngColorType.Rgba:
                row.CopyTo(target);
                break;
            case PngColorType.Rgb:
                ExpandRgb8(row, target);
                break;
            case PngColorType.GreyAlpha:
                for (int x = 0; 4 * x < target.Length; x++)
                {
                    target.Slice(4 * x, 3).Fill(row[2 * x]);
                    target[(4 * x) + 3] = row[(2 * x) + 1];
                }

                break;
            default:
                ExpandLookup(row, target);
                break;
        }
    }

    /// <summary>A row of a 16-bit picture.</summary>
    public void Expand16(ReadOnlySpan<byte> row, Span<ushort> target)
    {
        int channels = header.Channels;
        bool isColor = channels >= 3;
        for (int x = 0; 4 * x < target.Length; x++)
        {
            ReadOnlySpan<byte> pixel = row.Slice(2 * channels * x, 2 * channels);
            ushort r = BinaryPrimitives.ReadUInt16BigEndian(pixel);
            ushort g = isColor ? BinaryPrimitives.ReadUInt16BigEndian(pixel[2..]) : r;
            ushort b = isColor ? BinaryPrimitives.ReadUInt16BigEndian(pixel[4..]) : r;
            ushort a = channels % 2 == 0 ? BinaryPrimitives.ReadUInt16BigEndian(pixel[^2..]) : ushort.MaxValue;
            Span<ushort> to = target.Slice(4 * x, 4);
            (to[0], to[1], to[2], to[3]) = (r, g, b, clear == (r, g, b) ? (ushort)0 : a);
        }
    }

    private void ExpandRgb8(ReadOnlySpan<byte> row, Span<byte> target)
    {
        if (clear is not null)
        {
            for (int x = 0; 4 * x < target.Length; x++)
            {
                row.Slice(3 * x, 3).CopyTo(target[(4 * x)..]);
                bool isClear = clear == (row[3 * x], row[(3 * x) + 1], row[(3 * x) + 2]);
                target[(4 * x) + 3] = isClear ? (byte)0 : (byte)255;
            }

            return;
        }

        // Four bytes a step, of which the fourth is replaced; the last pixel has no fourth byte.
        int last = (target.Length / 4) - 1;
        for (int x = 0; x < last; x++)
        {
            uint pixel = BinaryPrimitives.ReadUInt32LittleEndian(row[(3 * x)..]) | 0xFF000000;
            BinaryPrimitives.WriteUInt32LittleEndian(target[(4 * x)..], pixel);
        }

        row.Slice(3 * last, 3).CopyTo(target[(4 * last)..]);
        target[^1] = 255;
    }

    private void ExpandLookup(ReadOnlySpan<byte> row, Span<byte> target)
    {
        int depth = header.BitDepth;
        int mask = (1 << depth) - 1;
        for (int x = 0; 4 * x < target.Length; x++)
        {
            // The leftmost pixel is in the highest bits.
            int bit = x * depth;
            int value = (row[bit >> 3] >> (8 - depth - (bit & 7))) & mask;
            if (4 * value >= lookup.Length)
            {
                throw new PictureFormatException(name, $"the colour index {value} is outside of the palette of {lookup.Length / 4} colours");
            }

            lookup.AsSpan(4 * value, 4).CopyTo(target[(4 * x)..]);
        }
    }
}
