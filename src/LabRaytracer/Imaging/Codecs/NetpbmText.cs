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

    /// <summary>Characters up to the next white space, which is taken too; spaces and comments before them are skipped.</summary>
    public static string ReadWord(PictureInput input)
    {
        byte next = input.ReadByte();
        while (IsSpace(next) || next == '#')
        {
            for (bool comment = next == '#'; comment && next is not ((byte)'\n' or (byte)'\r');)
            {
                next = input.ReadByte();
            }

            next = input.ReadByte();
        }

        StringBuilder word = new();
        for (int c = next; c >= 0 && !IsSpace((byte)c); c = input.TryReadByte())
        {
            if (c is <= ' ' or > '~' || word.Length == 20)
            {
                throw input.Bad("there is something other than a number in the header or the samples");
            }

            word.Append((char)c);
        }

        return word.ToString();
    }

    /// <summary>White space of C: blank, tab, line feed, vertical tab, form feed, carriage return.</summary>
    public static bool IsSpace(byte c) => c is (byte)' ' or (>= 9 and <= 13);
}
