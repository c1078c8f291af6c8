namespace LabRaytracer;

/// <summary>Buffered bytes of a picture file; the end of the file is a <see cref="PictureFormatException"/>.</summary>
internal sealed class PictureInput(Stream stream, string name)
{
    private readonly byte[] buffer = new byte[1 << 14];
    private int start;
    private int end;

    /// <summary>The next byte.</summary>
    /// <exception cref="PictureFormatException">The file ends.</exception>
    public byte ReadByte() => start < end || Fill() ? buffer[start++] : throw Short();

    /// <summary>The next byte, or -1 at the end of the file.</summary>
    public int TryReadByte() => start < end || Fill() ? buffer[start++] : -1;

    /// <summary>The next bytes, all of them.</summary>
    /// <exception cref="PictureFormatException">The file ends.</exception>
    public void ReadExactly(Span<byte> target)
    {
        int buffered = Math.Min(end - start, target.Length);
        buffer.AsSpan(start, buffered).CopyTo(target);
        start += buffered;
        if (buffered < target.Length && stream.ReadAtLeast(target[buffered..], target.Length - buffered, false) < target.Length - buffered)
        {
            throw Short();
        }
    }

    /// <summary>A line of ASCII without its end; at most <paramref name="maxLength"/> characters.</summary>
    /// <exception cref="PictureFormatException">The file ends, or the line is longer.</exception>
    public string ReadLine(int maxLength)
    {
        Span<char> line = stackalloc char[maxLength];
        int length = 0;
        for (byte next = ReadByte(); next != '\n'; next = ReadByte())
        {
            if (length == maxLength)
            {
                throw Bad($"a line of the header is longer than {maxLength} characters");
            }

            line[length++] = (char)next;
        }

        return new string(line[..length]).TrimEnd('\r');
    }

    /// <summary>The exception for a file that is wrong in some way.</summary>
    public PictureFormatException Bad(string reason) => new(name, reason);

    private PictureFormatException Short() => Bad("the file ends too early");

    private bool Fill()
    {
        start = 0;
        end = stream.Read(buffer);
        return end > 0;
    }
}
