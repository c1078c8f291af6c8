using System.Buffers;
using System.IO.Compression;
using System.Numerics;

namespace LabRaytracer;

/// <summary>Encodes, filters and compresses bands of rows; a band needs nothing of the one above. Thread safe.</summary>
internal sealed class PngBandCompressor(RowEncoder encoder, int width, PngCompression compression)
{
    private readonly ZLibCompressionOptions deflate = new()
    {
        CompressionLevel = compression switch
        {
            PngCompression.Fastest => 1,
            PngCompression.Smallest => 9,
            _ => 3,
        },
    };

    /// <summary>Compresses whole rows.</summary>
    public PngBand Compress(ReadOnlySpan<Intensity> rows)
    {
        int height = rows.Length / width;
        int rowBytes = width * encoder.BytesPerPixel;
        int rawLength = height * (rowBytes + 1);
        byte[] raw = ArrayPool<byte>.Shared.Rent(rawLength);
        byte[] codes = ArrayPool<byte>.Shared.Rent(3 * rowBytes);
        Span<byte> above = codes.AsSpan(0, rowBytes);
        Span<byte> row = codes.AsSpan(rowBytes, rowBytes);
        Span<byte> other = codes.AsSpan(2 * rowBytes, rowBytes);
        for (int y = 0; y < height; y++)
        {
            encoder.Encode(rows.Slice(y * width, width), y, row);
            Span<byte> target = raw.AsSpan(y * (rowBytes + 1), rowBytes + 1);
            Filter(row, y == 0 ? [] : above, target, other);
            Span<byte> swap = above;
            above = row;
            row = swap;
        }

        ReadOnlySpan<byte> filtered = raw.AsSpan(0, rawLength);
        using MemoryStream target2 = new(rawLength / 2);
        using (DeflateStream deflater = new(target2, deflate, leaveOpen: true))
        {
            deflater.Write(filtered);
            deflater.Flush();
            PngBand band = new(target2.GetBuffer().AsMemory(0, (int)target2.Length), Adler32.Compute(filtered), rawLength);
            ArrayPool<byte>.Shared.Return(raw);
            ArrayPool<byte>.Shared.Return(codes);
            return band;
        }
    }

    /// <summary>Sub or Up, whichever leaves the smaller sum of magnitudes (PNG specification, section 12.7).</summary>
    private void Filter(ReadOnlySpan<byte> row, ReadOnlySpan<byte> above, Span<byte> target, Span<byte> other)
    {
        int distance = encoder.BytesPerPixel;
        Span<byte> sub = target[1..];
        row[..distance].CopyTo(sub);
        Subtract(row[distance..], row[..^distance], sub[distance..]);
        target[0] = 1;
        if (above.IsEmpty)
        {
            return;
        }

        Subtract(row, above, other);
        if (SumOfMagnitudes(other) < SumOfMagnitudes(sub))
        {
            other.CopyTo(sub);
            target[0] = 2;
        }
    }

    private static void Subtract(ReadOnlySpan<byte> a, ReadOnlySpan<byte> b, Span<byte> target)
    {
        int i = 0;
        for (; i <= a.Length - Vector<byte>.Count; i += Vector<byte>.Count)
        {
            (new Vector<byte>(a[i..]) - new Vector<byte>(b[i..])).CopyTo(target[i..]);
        }

        for (; i < a.Length; i++)
        {
            target[i] = (byte)(a[i] - b[i]);
        }
    }

    private static long SumOfMagnitudes(ReadOnlySpan<byte> filtered)
    {
        long sum = 0;
        int i = 0;
        while (i <= filtered.Length - Vector<byte>.Count)
        {
            // A 16-bit lane takes 128 sums of two magnitudes of at most 128 each.
            Vector<ushort> sums = Vector<ushort>.Zero;
            for (int step = 0; step < 128 && i <= filtered.Length - Vector<byte>.Count; step++, i += Vector<byte>.Count)
            {
                Vector<byte> bytes = new(filtered[i..]);
                Vector.Widen(Vector.Min(bytes, Vector<byte>.Zero - bytes), out Vector<ushort> low, out Vector<ushort> high);
                sums += low + high;
            }

            Vector.Widen(sums, out Vector<uint> first, out Vector<uint> second);
            sum += Vector.Sum(first + second);
        }

        for (; i < filtered.Length; i++)
        {
            sum += Math.Min(filtered[i], 256 - filtered[i]);
        }

        return sum;
    }
}
