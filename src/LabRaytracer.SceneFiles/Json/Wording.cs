using System.Globalization;
using System.Text;

namespace LabRaytracer;

/// <summary>Words of messages: quoted texts, lists of names, "did you mean".</summary>
internal static class Wording
{
    private const int LongestQuote = 60;
    private const int MostNames = 24;

    /// <summary>A text of the file in quotes, on one line, cut where it is long.</summary>
    public static string Quote(string text) => $"'{Name(text)}'";

    /// <summary>A text of the file on one line, cut where it is long.</summary>
    public static string Name(string text)
    {
        StringBuilder line = new();
        foreach (char c in text.Length > LongestQuote ? text[..LongestQuote] : text)
        {
            // Line separators and direction marks would break or turn the line in a terminal.
            bool plain = !char.IsControl(c) && char.GetUnicodeCategory(c) is not (UnicodeCategory.Format or UnicodeCategory.LineSeparator
                or UnicodeCategory.ParagraphSeparator or UnicodeCategory.Surrogate);
            line.Append(plain ? c.ToString() : string.Create(CultureInfo.InvariantCulture, $"\\u{(int)c:x4}"));
        }

        return line.Append(text.Length > LongestQuote ? "..." : "").ToString();
    }

    /// <summary>Names, separated by commas; many are cut.</summary>
    public static string List(IEnumerable<string> names)
    {
        List<string> all = [.. names];
        string list = string.Join(", ", all.Take(MostNames).Select(Name));
        return all.Count <= MostNames ? list : string.Create(CultureInfo.InvariantCulture, $"{list}, ... ({all.Count} in all)");
    }

    /// <summary>", did you mean 'x'" for the name nearest to a misspelt one, or nothing.</summary>
    public static string Suggestion(string text, IEnumerable<string> names)
    {
        if (text.Length is 0 or > LongestQuote)
        {
            return "";
        }

        string? nearest = null;
        int best = Math.Max(1, text.Length / 3) + 1;
        foreach (string name in names)
        {
            int distance = Math.Abs(name.Length - text.Length) < best ? Distance(text, name) : int.MaxValue;
            if (distance < best)
            {
                (best, nearest) = (distance, name);
            }
        }

        return nearest is null ? "" : $", did you mean {Quote(nearest)}";
    }

    /// <summary>The message of an exception on one line, without the name of a parameter and without a full stop.</summary>
    public static string Reason(Exception failure)
    {
        string text = failure.Message.ReplaceLineEndings("\n").Split('\n')[0];
        int parameter = text.IndexOf(" (Parameter '", StringComparison.Ordinal);
        return (parameter < 0 ? text : text[..parameter]).TrimEnd('.', ' ');
    }

    /// <summary>Typing mistakes between two words: letters inserted, dropped, changed or swapped with their neighbour; case does not count.</summary>
    private static int Distance(string a, string b)
    {
        int[,] steps = new int[a.Length + 1, b.Length + 1];
        for (int i = 0; i <= a.Length; i++)
        {
            for (int j = 0; j <= b.Length; j++)
            {
                if (i == 0 || j == 0)
                {
                    steps[i, j] = i + j;
                    continue;
                }

                int change = steps[i - 1, j - 1] + (Same(a[i - 1], b[j - 1]) ? 0 : 1);
                int best = Math.Min(change, Math.Min(steps[i - 1, j], steps[i, j - 1]) + 1);
                bool swapped = i > 1 && j > 1 && Same(a[i - 1], b[j - 2]) && Same(a[i - 2], b[j - 1]);
                steps[i, j] = swapped ? Math.Min(best, steps[i - 2, j - 2] + 1) : best;
            }
        }

        return steps[a.Length, b.Length];
    }

    private static bool Same(char a, char b) => char.ToUpperInvariant(a) == char.ToUpperInvariant(b);
}
