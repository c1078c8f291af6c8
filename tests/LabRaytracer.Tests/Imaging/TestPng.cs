using System.Buffers.Binary;
using System.IO.Compression;
using System.Text;

namespace LabRaytracer.Tests;

/// <summary>A plain PNG writer, independent of the library's: every colour type, depth, filter and interlacing.</summary>
internal sealed class TestPng
{
    public static readonly byte[] Signature = [137, 80, 78, 71, 13, 10, 26, 10];

    private static readonly (int X, int Y, int Dx, int Dy)[] Adam7 =
        [(0, 0, 8, 8), (4, 0, 8, 8), (0, 4, 4, 8), (2, 0, 4, 4), (0, 2, 2, 4), (1, 0, 2, 2), (0, 1, 1, 2)];

    public required int Width { get; init; }

    public required int Height { get; init; }

    public required int Type { get; init; }

    public required int Depth { get; init; }

    public bool Interlaced { get; init; }

    /// <summary>Raw sample of column, row, channel.</summary>
    public required Func<int, int, int, int> Sample { get; init; }

    /// <summary>Chunks between IHDR and IDAT.</summary>
    public List<(string Type, byte[] Content)> Chunks { get; } = [];

    public int IdatSize { get; init; } = int.MaxValue;

    public int Channels => Type switch { 2 => 3, 4 => 2, 6 => 4, _ => 1 };

    public byte[] ToBytes()
    {
        MemoryStream file = new();
        file.Write(Signature);
        byte[] header = new byte[13];
        BinaryPrimitives.WriteInt32BigEndian(header, Width);
        BinaryPrimitives.WriteInt32BigEndian(header.AsSpan(4), Height);
        (header[8], header[9], header[12]) = ((byte)Depth, (byte)Type, (byte)(Interlaced ? 1 : 0));
        WriteChunk(file, "IHDR", header);
        foreach ((string type, byte[] content) in Chunks)
        {
            WriteChunk(file, type, content);
        }

        byte[] data = Deflate(FilteredRows());
        for (int i = 0; i < data.Length; i += Math.Min(IdatSize, data.Length - i))
        {
            WriteChunk(file, "IDAT", data.AsSpan(i, Math.Min(IdatSize, data.Length - i)).ToArray());
        }

        WriteChunk(file, "IEND", []);
        return file.ToArray();
    }

    public static byte[] Deflate(byte[] raw)
    {
        MemoryStream target = new();
        using (ZLibStream zlib = new(target, CompressionLevel.Fastest, leaveOpen: true))
        {
            zlib.Write(raw);
        }

        return target.ToArray();
    }

    public static void WriteChunk(Stream file, string type, byte[] content)
    {
        byte[] body = [.. Encoding.ASCII.GetBytes(type), .. content];
        byte[] word = new byte[4];
        BinaryPrimitives.WriteInt32BigEndian(word, content.Length);
        file.Write(word);
        file.Write(body);
        BinaryPrimitives.WriteUInt32BigEndian(word, Crc(body));
        file.Write(word);
    }

    private byte[] FilteredRows()
    {
        MemoryStream rows = new();
        foreach ((int x0, int y0, int dx, int dy) in Interlaced ? Adam7 : [(0, 0, 1, 1)])
        {
            byte[]? above = null;
            for (int y = y0; y < Height && x0 < Width; y += dy)
            {
                byte[] row = PackedRow(x0, dx, y);
                byte filter = (byte)((y / dy) % 5);
                rows.WriteByte(filter);
                rows.Write(Filter(filter, row, above ?? new byte[row.Length], Math.Max(1, Channels * Depth / 8)));
                above = row;
            }
        }

        return rows.ToArray();
    }

    private byte[] PackedRow(int x0, int dx, int y)
    {
        List<bool> bits = [];
        for (int x = x0; x < Width; x += dx)
        {
            for (int c = 0; c < Channels; c++)
            {
                for (int bit = Depth - 1; bit >= 0; bit--)
                {
                    bits.Add(((Sample(x, y, c) >> bit) & 1) != 0);
                }
            }
        }

        byte[] row = new byte[(bits.Count + 7) / 8];
        for (int i = 0; i < bits.Count; i++)
        {
            row[i / 8] |= (byte)(bits[i] ? 128 >> (i % 8) : 0);
        }

        return row;
    }

    private static byte[] Filter(byte filter, byte[] row, byte[] above, int distance)
    {
        byte[] result = new byte[row.Length];
        for (int i = 0; i < row.Length; i++)
        {
            int a = i < distance ? 0 : row[i - distance];
            int b = above[i];
            int c = i < distance ? 0 : above[i - distance];
            int p = a + b - c;
            int paeth = Math.Abs(p - a) <= Math.Abs(p - b) && Math.Abs(p - a) <= Math.Abs(p - c) ? a : Math.Abs(p - b) <= Math.Abs(p - c) ? b : c;
            int[] predictions = [0, a, b, (a + b) / 2, paeth];
            result[i] = (byte)(row[i] - predictions[filter]);
        }

        return result;
    }

    private static uint Crc(byte[] data)
    {
        uint crc = uint.MaxValue;
        foreach (byte b in data)
        {
            crc ^= b;
            for (int bit = 0; bit < 8; bit++)
            {
                crc = (crc >> 1) ^ ((crc & 1) * 0xEDB88320);
            }
        }

        return ~crc;
    }
}
