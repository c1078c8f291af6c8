using System.Buffers.Binary;
using System.IO.Compression;
using System.Text;
using LabRaytracer;

namespace RenderScene;

/// <summary>Writes small PNG pictures with alpha, 8 bits a channel.</summary>
internal static class RgbaPng
{
    /// <summary>A picture as a file.</summary>
    /// <param name="width">Columns.</param>
    /// <param name="height">Rows.</param>
    /// <param name="pixel">Linear colour, not multiplied by alpha, and alpha of column x and row y from the top.</param>
    public static byte[] Encode(int width, int height, Func<int, int, (Intensity Color, float Alpha)> pixel)
    {
        byte[] rows = new byte[height * ((4 * width) + 1)];
        for (int y = 0; y < height; y++)
        {
            // The byte before each row says that it is not filtered.
            Span<byte> row = rows.AsSpan(y * ((4 * width) + 1), (4 * width) + 1)[1..];
            for (int x = 0; x < width; x++)
            {
                (Intensity color, float alpha) = pixel(x, y);
                row[4 * x] = ColorEncoding.Srgb8FromLinear(color.R);
                row[(4 * x) + 1] = ColorEncoding.Srgb8FromLinear(color.G);
                row[(4 * x) + 2] = ColorEncoding.Srgb8FromLinear(color.B);
                row[(4 * x) + 3] = (byte)MathF.Round(255 * Math.Clamp(alpha, 0, 1));
            }
        }

        return Wrap(width, height, rows);
    }

    private static byte[] Wrap(int width, int height, byte[] rows)
    {
        using MemoryStream file = new();
        file.Write([0x89, (byte)'P', (byte)'N', (byte)'G', 13, 10, 26, 10]);
        byte[] header = new byte[13];
        BinaryPrimitives.WriteInt32BigEndian(header, width);
        BinaryPrimitives.WriteInt32BigEndian(header.AsSpan(4), height);
        (header[8], header[9]) = (8, 6);
        WriteChunk(file, "IHDR", header);
        WriteChunk(file, "sRGB", [0]);
        using MemoryStream data = new();
        using (ZLibStream packed = new(data, CompressionLevel.SmallestSize, leaveOpen: true))
        {
            packed.Write(rows);
        }

        WriteChunk(file, "IDAT", data.ToArray());
        WriteChunk(file, "IEND", []);
        return file.ToArray();
    }

    private static void WriteChunk(MemoryStream file, string name, byte[] content)
    {
        byte[] chunk = [.. Encoding.ASCII.GetBytes(name), .. content];
        Span<byte> number = stackalloc byte[4];
        BinaryPrimitives.WriteInt32BigEndian(number, content.Length);
        file.Write(number);
        file.Write(chunk);
        BinaryPrimitives.WriteUInt32BigEndian(number, Crc32.Append(0, chunk));
        file.Write(number);
    }
}
