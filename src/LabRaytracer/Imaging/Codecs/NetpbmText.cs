using System.Globalization;
using System.Text;

namespace LabRaytracer;

/// <summary>The words of a Netpbm header, and the samples of its text forms.</summary>
internal static class NetpbmText
{
    /// <summary>A decimal number and the one white space after it; spaces and comments before it are skipped.</summary>
    public static int ReadNumber(PictureInput input)
    {
        string word = ReadWord(input);
        return int.TryParse(word, NumberStyles.None, CultureInfo.InvariantCulture, out int value)
            ? value
            : throw input.Bad($"'{word}' stands where a whole number is needed");
    }

    /// <summary>Characters up to the next white space, which is taken too; white space before them is skipped, a comment counts as its line's end.</summary>
    public static string ReadWord(PictureInput input)
    {
        int next = NextCharacter(input);
        while (next >= 0 && IsSpace((byte)next))
        {
            next = NextCharacter(input);
        }

        StringBuilder word = new();
        for (; next >= 0 && !IsSpace((byte)next); next = NextCharacter(input))
        {
            if (next is <= ' ' or > '~' || word.Length == 20)
            {
                throw input.Bad("there is something other than a number in the header or the samples");
            }

            word.Append((char)next);
        }

        return word.Length > 0 ? word.ToString() : throw input.Bad("the file ends too early");
    }

    /// <summary>White space of C: blank, tab, line feed, vertical tab, form feed, carriage return.</summary>
    public static bool IsSpace(byte c) => c is (byte)' ' or (>= 9 and <= 13);

    /// <summary>The next character; a comment, from # to the end of its line, is read as that end. -1 at the end of the file.</summary>
    private static int NextCharacter(PictureInput input)
    {
        int next = input.TryReadByte();
        if (next == '#')
        {
            while (next is not ('\n' or '\r' or -1))
            {
                next = input.TryReadByte();
            }
        }

        return next;
    }
}
