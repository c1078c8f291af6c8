namespace LabRaytracer;

/// <summary>The run lengths of Radiance pictures: one line of RGBE pixels at a time.</summary>
internal static class HdrRunLength
{
    private const int MinNewLength = 8;
    private const int MaxNewLength = 0x7FFF;
    private const int MinRun = 4;

    /// <summary>Reads a line of 4 bytes a pixel, whatever its coding.</summary>
    /// <exception cref="PictureFormatException">A run leaves the line, or the file ends.</exception>
    public static void ReadLine(PictureInput input, Span<byte> line)
    {
        int length = line.Length / 4;
        Span<byte> head = stackalloc byte[4];
        input.ReadExactly(head);
        bool isNew = head[0] == 2 && head[1] == 2 && head[2] < 128 && length is >= MinNewLength and <= MaxNewLength;
        if (!isNew)
        {
            ReadOldLine(input, head, line);
            return;
        }

        if (((head[2] << 8) | head[3]) != length)
        {
            throw input.Bad("a line has another length than the header says");
        }

        for (int channel = 0; channel < 4; channel++)
        {
            ReadChannel(input, line, channel);
        }
    }

    /// <summary>Writes a line in the new coding, or flat where that is not possible.</summary>
    public static void WriteLine(Stream stream, ReadOnlySpan<byte> line)
    {
        int length = line.Length / 4;
        if (length is < MinNewLength or > MaxNewLength)
        {
            stream.Write(line);
            return;
        }

        stream.Write([2, 2, (byte)(length >> 8), (byte)length]);
        for (int channel = 0; channel < 4; channel++)
        {
            WriteChannel(stream, line, channel);
        }
    }

    private static void ReadChannel(PictureInput input, Span<byte> line, int channel)
    {
        int length = line.Length / 4;
        for (int x = 0; x < length;)
        {
            int code = input.ReadByte();
            bool isRun = code > 128;
            int count = isRun ? code - 128 : code;
            if (count == 0 || count > length - x)
            {
                throw input.Bad("a run of pixels leaves its line");
            }

            byte value = isRun ? input.ReadByte() : (byte)0;
            for (int end = x + count; x < end; x++)
            {
                line[(4 * x) + channel] = isRun ? value : input.ReadByte();
            }
        }
    }

    /// <summary>Flat pixels, and the old runs: (1, 1, 1, n) repeats the pixel before it n times, 256 n right after another run.</summary>
    private static void ReadOldLine(PictureInput input, Span<byte> pixel, Span<byte> line)
    {
        int length = line.Length / 4;
        int shift = 0;
        for (int x = 0; x < length;)
        {
            bool isRun = pixel[0] == 1 && pixel[1] == 1 && pixel[2] == 1;
            if (isRun)
            {
                long count = shift > 16 ? long.MaxValue : (long)pixel[3] << shift;
                if (x == 0 || count > length - x)
                {
                    throw input.Bad("a run of pixels leaves its line");
                }

                for (long end = x + count; x < end; x++)
                {
                    line.Slice(4 * (x - 1), 4).CopyTo(line[(4 * x)..]);
                }

                shift += 8;
            }
            else
            {
                pixel.CopyTo(line[(4 * x)..]);
                x++;
                shift = 0;
            }

            if (x < length)
            {
                input.ReadExactly(pixel);
            }
        }
    }

    private static void WriteChannel(Stream stream, ReadOnlySpan<byte> line, int channel)
    {
        int length = line.Length / 4;
        Span<byte> literal = stackalloc byte[129];
        int pending = 0;
        for (int x = 0; x < length;)
        {
            int run = 1;
            while (run < 127 && x + run < length && line[(4 * (x + run)) + channel] == line[(4 * x) + channel])
            {
                run++;
            }

            if (run < MinRun)
            {
                literal[1 + pending] = line[(4 * x) + channel];
                pending++;
                x++;
            }

            if (pending == 128 || (pending > 0 && (run >= MinRun || x == length)))
            {
                literal[0] = (byte)pending;
                stream.Write(literal[..(1 + pending)]);
                pending = 0;
            }

            if (run >= MinRun)
            {
                stream.Write([(byte)(128 + run), line[(4 * x) + channel]]);
                x += run;
            }
        }
    }
}
