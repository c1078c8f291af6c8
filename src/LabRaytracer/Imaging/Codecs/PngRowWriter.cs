using System.Buffers.Binary;
using System.Text;

namespace LabRaytracer;

/// <summary>Writes a PNG file whose rows are handed over from the top while the picture is still being made.</summary>
/// <remarks>
/// The rows are cut into bands of a fixed height; the bands are filtered and compressed in parallel, each ending at a byte boundary
/// (a sync flush), so that they can be joined into one zlib stream. The bytes do not depend on the number of threads nor on how rows are handed over.
/// </remarks>
internal sealed class PngRowWriter : IBandSink
{
    /// <summary>Rows of a band are a multiple of this: the height of a tile of the renderer, so that a row of tiles never lies in two bands.</summary>
    public const int RowStep = 32;

    private const int BandBytes = 1 << 18;
    private const int MaxChunkBytes = 1 << 20;
    private readonly Stream stream;
    private readonly int width;
    private readonly int height;
    private readonly int bandRows;
    private readonly PngBandCompressor compressor;
    private readonly List<Intensity> pending = [];
    private int rowsWritten;
    private uint adler = Adler32.Empty;
    private bool hasZlibHeader;

    /// <summary>Writes the header.</summary>
    public PngRowWriter(Stream stream, int width, int height, PictureSaveOptions options)
    {
        PictureSize.Check(width, height);
        (this.stream, this.width, this.height) = (stream, width, height);
        RowEncoder encoder = new(options.Encoding, options.BitDepth, options.ToneMapping, options.Dithering);
        compressor = new PngBandCompressor(encoder, width, options.PngCompression);
        bandRows = RowStep * (int)Math.Max(1, BandBytes / ((long)RowStep * width * encoder.BytesPerPixel));
        stream.Write(PngCodec.Signature);
        Span<byte> header = stackalloc byte[13];
        header.Clear();
        BinaryPrimitives.WriteInt32BigEndian(header, width);
        BinaryPrimitives.WriteInt32BigEndian(header[4..], height);
        header[8] = (byte)options.BitDepth;
        header[9] = (byte)PngColorType.Rgb;
        WriteChunk("IHDR", header);
        WriteTransfer(options.Encoding);
        foreach ((string key, string text) in options.Text)
        {
            WriteText(key, text);
        }
    }

    /// <inheritdoc/>
    public int BandRows => bandRows;

    /// <inheritdoc/>
    /// <remarks>Not to be mixed with <see cref="WriteRows"/>.</remarks>
    public Action Prepare(ReadOnlySpan<Intensity> rows)
    {
        int count = rows.Length / width;
        PngBand band = compressor.Compress(rows);
        return () =>
        {
            WriteBand(band);
            rowsWritten += count;
        };
    }

    /// <summary>Takes the next rows; a multiple of the width.</summary>
    public void WriteRows(ReadOnlyMemory<Intensity> rows)
    {
        int bandPixels = bandRows * width;
        if (pending.Count > 0)
        {
            int missing = Math.Min(bandPixels - pending.Count, rows.Length);
            pending.AddRange(rows.Span[..missing]);
            rows = rows[missing..];
            if (pending.Count == bandPixels)
            {
                WriteBands(pending.ToArray());
                pending.Clear();
            }
        }

        int whole = rows.Length / bandPixels * bandPixels;
        WriteBands(rows[..whole]);
        pending.AddRange(rows.Span[whole..]);
    }

    /// <summary>Ends the file; all rows must have been written.</summary>
    public void Finish()
    {
        WriteBands(pending.ToArray());
        if (rowsWritten != height)
        {
            throw new InvalidOperationException($"{rowsWritten} of {height} rows of the picture were written; write them all before finishing.");
        }

        // An empty last block (RFC 1951, fixed codes), then the checksum of RFC 1950.
        Span<byte> end = [3, 0, (byte)(adler >> 24), (byte)(adler >> 16), (byte)(adler >> 8), (byte)adler];
        WriteChunk("IDAT", end);
        WriteChunk("IEND", []);
    }

    /// <summary>Compresses a few bands for each thread at a time, so that memory does not grow with the picture.</summary>
    private void WriteBands(ReadOnlyMemory<Intensity> rows)
    {
        int bandPixels = bandRows * width;
        int batchPixels = 8 * Environment.ProcessorCount * bandPixels;
        for (; rows.Length > 0; rows = rows[Math.Min(batchPixels, rows.Length)..])
        {
            ReadOnlyMemory<Intensity> batch = rows[..Math.Min(batchPixels, rows.Length)];
            PngBand[] bands = new PngBand[(batch.Length + bandPixels - 1) / bandPixels];
            if (bands.Length == 1)
            {
                bands[0] = compressor.Compress(batch.Span);
            }
            else
            {
                Parallel.For(0, bands.Length, i =>
                {
                    int start = i * bandPixels;
                    bands[i] = compressor.Compress(batch.Span.Slice(start, Math.Min(bandPixels, batch.Length - start)));
                });
            }

            foreach (PngBand band in bands)
            {
                WriteBand(band);
            }

            rowsWritten += batch.Length / width;
        }
    }

    private void WriteBand(PngBand band)
    {
        adler = Adler32.Combine(adler, band.Adler, band.RawLength);
        ReadOnlySpan<byte> rest = band.Compressed.Span;
        if (!hasZlibHeader)
        {
            // 32 KiB window, default level (RFC 1950).
            WriteChunk("IDAT", [0x78, 0x9C]);
            hasZlibHeader = true;
        }

        for (; rest.Length > 0; rest = rest[Math.Min(MaxChunkBytes, rest.Length)..])
        {
            WriteChunk("IDAT", rest[..Math.Min(MaxChunkBytes, rest.Length)]);
        }
    }

    private void WriteTransfer(TransferFunction transfer)
    {
        if (transfer.IsSrgb)
        {
            WriteChunk("sRGB", [0]);
        }

        // sRGB files also carry the nearest power for programs that know nothing else.
        double exponent = transfer.IsSrgb ? 2.2 : transfer.Exponent;
        Span<byte> gamma = stackalloc byte[4];
        BinaryPrimitives.WriteUInt32BigEndian(gamma, (uint)((100000 / exponent) + 0.5));
        WriteChunk("gAMA", gamma);
    }

    /// <summary>tEXt if Latin-1 will do, otherwise iTXt (PNG specification, section 11.3.3).</summary>
    private void WriteText(string key, string text)
    {
        bool isLatin = text.All(c => c is '\n' or (>= ' ' and <= '~') or (>= (char)161 and <= (char)255));
        byte[] content = isLatin
            ? Encoding.Latin1.GetBytes($"{key}\0{text}")
            : [.. Encoding.Latin1.GetBytes(key), 0, 0, 0, 0, 0, .. Encoding.UTF8.GetBytes(text)];
        WriteChunk(isLatin ? "tEXt" : "iTXt", content);
    }

    private void WriteChunk(string type, ReadOnlySpan<byte> content)
    {
        Span<byte> head = stackalloc byte[8];
        BinaryPrimitives.WriteInt32BigEndian(head, content.Length);
        Encoding.ASCII.GetBytes(type, head[4..]);
        stream.Write(head);
        stream.Write(content);
        uint crc = Crc32.Append(Crc32.Append(0, head[4..]), content);
        BinaryPrimitives.WriteUInt32BigEndian(head, crc);
        stream.Write(head[..4]);
    }
}
