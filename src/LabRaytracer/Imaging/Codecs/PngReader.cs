using System.IO.Compression;

namespace LabRaytracer;

/// <summary>Reads one PNG file.</summary>
internal sealed class PngReader
{
    private const int BlockBytes = 1 << 16;

    // Fewer blocks are unfiltered before another thread has begun.
    private const int ManyBlocks = 8;

    // The seven passes of Adam7: first column and row, steps (PNG specification, section 8.2).
    private static readonly (int X, int Y, int StepX, int StepY)[] Passes =
        [(0, 0, 8, 8), (4, 0, 8, 8), (0, 4, 4, 8), (2, 0, 4, 4), (0, 2, 2, 4), (1, 0, 2, 2), (0, 1, 1, 2)];

    private readonly PngChunks chunks;
    private readonly PictureLimits limits;
    private readonly string name;
    private readonly PngColorInfo color = new();
    private readonly HashSet<string> seen = [];
    private PngHeader header;
    private byte[] samples8 = [];
    private ushort[] samples16 = [];

    /// <summary>Prepares to read; the stream stands behind the signature.</summary>
    public PngReader(Stream stream, PictureLimits limits, string name)
    {
        (this.limits, this.name) = (limits, name);
        chunks = new PngChunks(stream, name);
    }

    /// <summary>Reads the file up to and including the IEND chunk; what follows is not looked at.</summary>
    public PixelBuffer Read()
    {
        chunks.Next();
        if (chunks.Type != "IHDR")
        {
            throw chunks.Bad("the first chunk is not IHDR");
        }

        header = PngHeader.Parse(chunks.ReadAll(13), limits, name);
        PngPalette palette = new(header, name);
        for (chunks.Next(); chunks.Type != "IDAT"; chunks.Next())
        {
            ReadChunk(palette);
        }

        if (header.ColorType == PngColorType.Palette && !palette.HasColors)
        {
            throw chunks.Bad("the palette (PLTE chunk) is missing");
        }

        ReadImage(new PngRowExpander(header, palette, name));
        ReadEnd();
        (TransferFunction transfer, string source) = color.Resolve();
        return header.BitDepth == 16
            ? PixelBuffer.FromRgba16(header.Width, header.Height, samples16, transfer, source)
            : PixelBuffer.FromRgba8(header.Width, header.Height, samples8, transfer, source).GivenAway();
    }

    private void ReadChunk(PngPalette palette)
    {
        string type = chunks.Type;
        if (type == "PLTE")
        {
            palette.AddColors(chunks.ReadAll(3 * 256));
        }
        else if (type == "tRNS")
        {
            palette.AddTransparency(chunks.ReadAll(256));
        }
        else if (PngColorInfo.Keeps(type))
        {
            if (palette.HasColors || !seen.Add(type))
            {
                throw chunks.Bad($"chunk {type} is doubled or behind the palette");
            }

            if (!color.Add(type, chunks.ReadAll(limits.MaxChunkBytes)))
            {
                throw chunks.Bad($"chunk {type} has a wrong length or no name");
            }
        }
        else if (chunks.IsCritical)
        {
            throw chunks.Bad(type is "IHDR" or "IEND" ? $"chunk {type} stands before the pixels" : $"the critical chunk {type} is not known");
        }
        else
        {
            chunks.Finish();
        }
    }

    private void ReadEnd()
    {
        for (; chunks.Type != "IEND"; chunks.Next())
        {
            if (chunks.IsCritical || chunks.Type == "tRNS" || PngColorInfo.Keeps(chunks.Type))
            {
                throw chunks.Bad($"chunk {chunks.Type} stands behind the pixels");
            }

            chunks.Finish();
        }

        if (chunks.Remaining != 0)
        {
            throw chunks.Bad("the IEND chunk is not empty");
        }

        chunks.Finish();
    }

    private void ReadImage(PngRowExpander expander)
    {
        PngImageData data = new(chunks);
        using ZLibStream inflated = new(data, CompressionMode.Decompress, leaveOpen: true);
        try
        {
            foreach ((int x, int y, int stepX, int stepY) in header.IsInterlaced ? Passes : [(0, 0, 1, 1)])
            {
                int width = (header.Width - x + stepX - 1) / stepX;
                int height = (header.Height - y + stepY - 1) / stepY;
                if (width > 0 && height > 0)
                {
                    ReadPass(inflated, expander, new PngPass(x, y, stepX, stepY, width, height));
                }
            }

            if (inflated.ReadByte() >= 0)
            {
                throw chunks.Bad("there are more pixels than the size says");
            }
        }
        catch (Exception damage) when (damage is InvalidDataException || (damage is IOException && !data.SourceFailed))
        {
            // Damage to zlib's own header comes as an IOException of the framework.
            throw new PictureFormatException(name, "the compressed pixels are damaged or end too early", damage);
        }

        Span<byte> rest = stackalloc byte[1024];
        while (data.Read(rest) > 0)
        {
            // Up to the chunk behind the pixels, so that every checksum is verified.
        }
    }

    /// <summary>Inflates and unfilters blocks of rows; of a large picture the next block is inflated while one is unfiltered on another thread.</summary>
    private void ReadPass(ZLibStream inflated, PngRowExpander expander, PngPass pass)
    {
        int stride = header.RowBytes(pass.Width) + 1;
        int rowsInBlock = Math.Clamp(BlockBytes / stride, 1, pass.Height);
        bool isLarge = Environment.ProcessorCount > 1 && pass.Height / rowsInBlock >= ManyBlocks;

        // Slot 0 of a buffer is the row above its block.
        byte[] buffer = new byte[(rowsInBlock + 1) * stride];
        byte[] next = isLarge ? new byte[buffer.Length] : buffer;
        Task unfiltering = Task.CompletedTask;
        for (int first = 0; first < pass.Height; first += rowsInBlock)
        {
            int rows = Math.Min(rowsInBlock, pass.Height - first), firstRow = first;
            try
            {
                Inflate(inflated, buffer.AsSpan(stride, rows * stride));
            }
            finally
            {
                // Mistakes are told in the order of the file.
                unfiltering.GetAwaiter().GetResult();
            }

            // Taken only after the first rows are there: a size in a header is only a claim.
            Allocate();
            byte[] current = buffer, following = next;
            if (isLarge)
            {
                unfiltering = Task.Run(() => Unfilter(expander, current.AsSpan(0, (rows + 1) * stride), following, pass, firstRow));
            }
            else
            {
                Unfilter(expander, current.AsSpan(0, (rows + 1) * stride), following, pass, firstRow);
            }

            (buffer, next) = (next, buffer);
        }

        unfiltering.GetAwaiter().GetResult();
    }

    private void Inflate(ZLibStream inflated, Span<byte> block)
    {
        if (inflated.ReadAtLeast(block, block.Length, throwOnEndOfStream: false) < block.Length)
        {
            throw chunks.Bad("the pixels end too early");
        }
    }

    /// <summary>Unfilters and places rows; the last one goes into slot 0 of the next buffer.</summary>
    private void Unfilter(PngRowExpander expander, Span<byte> slots, Span<byte> next, PngPass pass, int firstRow)
    {
        int stride = header.RowBytes(pass.Width) + 1;
        for (int slot = stride; slot < slots.Length; slot += stride)
        {
            Span<byte> row = slots.Slice(slot + 1, stride - 1);
            ReadOnlySpan<byte> above = slots.Slice(slot - stride + 1, stride - 1);
            if (!PngUnfilter.Apply(slots[slot], row, above, header.FilterDistance))
            {
                throw chunks.Bad($"the row filter {slots[slot]} does not exist; 0 to 4 do");
            }

            Place(expander, row, pass, firstRow++);
        }

        slots[^stride..].CopyTo(next);
    }

    private void Allocate()
    {
        int length = 4 * header.Width * header.Height;
        if (header.BitDepth == 16 && samples16.Length == 0)
        {
            samples16 = GC.AllocateUninitializedArray<ushort>(length);
        }
        else if (header.BitDepth < 16 && samples8.Length == 0)
        {
            samples8 = GC.AllocateUninitializedArray<byte>(length);
        }
    }

    private void Place(PngRowExpander expander, ReadOnlySpan<byte> row, PngPass pass, int passRow)
    {
        int start = 4 * (((pass.Y + (passRow * pass.StepY)) * header.Width) + pass.X);
        if (header.BitDepth == 16)
        {
            Span<ushort> target = samples16.AsSpan(start, 4 * ((pass.Width * pass.StepX) - pass.StepX + 1));
            Span<ushort> packed = pass.StepX == 1 ? target : new ushort[4 * pass.Width];
            expander.Expand16(row, packed);
            Spread(packed, target, pass.StepX);
        }
        else
        {
            Span<byte> target = samples8.AsSpan(start, 4 * ((pass.Width * pass.StepX) - pass.StepX + 1));
            Span<byte> packed = pass.StepX == 1 ? target : new byte[4 * pass.Width];
            expander.Expand8(row, packed);
            Spread(packed, target, pass.StepX);
        }
    }

    /// <summary>Puts the pixels of an interlaced row at their columns.</summary>
    private static void Spread<T>(ReadOnlySpan<T> packed, Span<T> target, int step)
    {
        for (int x = 0; step > 1 && 4 * x < packed.Length; x++)
        {
            packed.Slice(4 * x, 4).CopyTo(target[(4 * x * step)..]);
        }
    }

    private readonly record struct PngPass(int X, int Y, int StepX, int StepY, int Width, int Height);
}
