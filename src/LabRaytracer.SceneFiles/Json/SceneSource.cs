using System.Text;

namespace LabRaytracer;

/// <summary>The bytes of a text file, and where its lines start.</summary>
internal sealed class SceneSource
{
    private volatile int[]? _lineStarts;

    public SceneSource(string file, byte[] bytes)
    {
        File = file;
        Bytes = bytes;
        TextStart = bytes.AsSpan().StartsWith("\uFEFF"u8) ? 3 : 0;
    }

    /// <summary>Name of the file as it was given.</summary>
    public string File { get; }

    /// <summary>All bytes, with the byte order mark if there is one.</summary>
    public byte[] Bytes { get; }

    /// <summary>Offset of the first byte after the byte order mark.</summary>
    public int TextStart { get; }

    /// <summary>Line and column of a byte. Thread safe.</summary>
    public SceneLocation Locate(int offset)
    {
        int[] starts = _lineStarts ??= FindLineStarts();
        int line = Array.BinarySearch(starts, offset);
        line = line >= 0 ? line : ~line - 1;
        ReadOnlySpan<byte> before = Bytes.AsSpan(starts[line], offset - starts[line]);
        return new SceneLocation(File, line + 1, Encoding.UTF8.GetCharCount(before) + 1);
    }

    // A line ends at LF, at CR LF, or at a CR alone, as editors count.
    private int[] FindLineStarts()
    {
        List<int> starts = [TextStart];
        ReadOnlySpan<byte> text = Bytes;
        int at = TextStart;
        while (text[at..].IndexOfAny((byte)'\r', (byte)'\n') is var step && step >= 0)
        {
            at += step;
            at += text[at] == '\r' && at + 1 < text.Length && text[at + 1] == '\n' ? 2 : 1;
            starts.Add(at);
        }

        return [.. starts];
    }
}
