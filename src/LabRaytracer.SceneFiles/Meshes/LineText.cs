using System.Globalization;

namespace LabRaytracer;

/// <summary>Reads the words and numbers of one logical line of an OBJ or MTL file: one that may go on after a backslash at its end.</summary>
internal ref struct LineText
{
    private readonly ReadOnlySpan<byte> _bytes;

    /// <summary>Reads from a place to the end of its logical line.</summary>
    /// <param name="bytes">The whole file.</param>
    /// <param name="start">Offset of the first byte of the line.</param>
    public LineText(ReadOnlySpan<byte> bytes, int start)
    {
        _bytes = bytes;
        Position = start;
        End = FindEnd(bytes, start);
    }

    /// <summary>Offset of the next byte.</summary>
    public int Position { get; private set; }

    /// <summary>Offset after the last byte of the line, without its line end.</summary>
    public int End { get; }

    /// <summary>Offset of the line that follows.</summary>
    public readonly int Next => Math.Min(End + 1, _bytes.Length);

    /// <summary>What is left of the line.</summary>
    public readonly ReadOnlySpan<byte> Ahead => _bytes[Position..End];

    /// <summary>Goes to the next word; false at the end of the line or at a comment.</summary>
    public bool ToWord()
    {
        int at = Position;
        while (at < End && IsSpace(_bytes[at], at))
        {
            at++;
        }

        Position = at;
        return at < End && _bytes[at] != '#';
    }

    /// <summary>The next word; empty at the end of the line.</summary>
    public ReadOnlySpan<byte> Word()
    {
        if (!ToWord())
        {
            return [];
        }

        int start = Position;
        SkipWord();
        return _bytes[start..Position];
    }

    /// <summary>Goes to the end of the current word.</summary>
    public void SkipWord()
    {
        int at = Position;
        while (at < End && !IsSpace(_bytes[at], at))
        {
            at++;
        }

        Position = at;
    }

    /// <summary>The rest of the line without spaces at its ends: a name, which may have spaces inside.</summary>
    public ReadOnlySpan<byte> Rest()
    {
        ReadOnlySpan<byte> rest = ToWord() ? _bytes[Position..End].TrimEnd(" \t"u8) : [];
        Position = End;
        return rest;
    }

    /// <summary>Reads a finite number; false leaves the position at the word.</summary>
    public bool TryNumber(out double value)
    {
        value = 0;
        if (!ToWord())
        {
            return false;
        }

        int length = DecimalText.Read(_bytes[Position..End], out value);
        int after = Position + length;
        if (length == 0 || !double.IsFinite(value) || (after < End && !IsSpace(_bytes[after], after)))
        {
            return false;
        }

        Position = after;
        return true;
    }

    /// <summary>Reads one index of a corner, such as 12 or -1, at the very position; false if there is none or it is too large.</summary>
    public bool TryIndex(out int value)
    {
        int at = Position;
        bool negative = at < End && _bytes[at] == '-';
        at += negative || (at < End && _bytes[at] == '+') ? 1 : 0;
        int first = at;
        long number = 0;
        while (at < End && (uint)(_bytes[at] - '0') <= 9 && at - first < 10)
        {
            number = (number * 10) + (_bytes[at++] - '0');
        }

        value = (int)Math.Clamp(negative ? -number : number, int.MinValue, int.MaxValue);
        Position = at;
        return at > first && number <= int.MaxValue;
    }

    /// <summary>Goes over a slash at the very position.</summary>
    public bool TrySlash()
    {
        bool slash = Position < End && _bytes[Position] == '/';
        Position += slash ? 1 : 0;
        return slash;
    }

    /// <summary>Tells whether a word ends at the position.</summary>
    public readonly bool AtWordEnd => Position >= End || IsSpace(_bytes[Position], Position);

    /// <summary>A mistake at the next word, as one word of text for messages.</summary>
    public readonly string Describe()
    {
        LineText ahead = this;
        string word = System.Text.Encoding.UTF8.GetString(ahead.Word());
        return word.Length == 0 ? "the line ends too early" : string.Create(CultureInfo.InvariantCulture, $"{Wording.Quote(word)} does not fit");
    }

    private static int FindEnd(ReadOnlySpan<byte> bytes, int start)
    {
        int at = start;
        while (true)
        {
            int step = bytes[at..].IndexOfAny((byte)'\n', (byte)'\r');
            if (step < 0)
            {
                return bytes.Length;
            }

            at += step;
            if (at == 0 || bytes[at - 1] != '\\')
            {
                return at;
            }

            at += bytes[at] == '\r' && at + 1 < bytes.Length && bytes[at + 1] == '\n' ? 2 : 1;
        }
    }

    // Inside a line, line ends and the backslashes before them separate words.
    private readonly bool IsSpace(byte c, int at) =>
        c is (byte)' ' or (byte)'\t' or (byte)'\n' or (byte)'\r' || (c == '\\' && at + 1 < _bytes.Length && _bytes[at + 1] is (byte)'\n' or (byte)'\r');
}
