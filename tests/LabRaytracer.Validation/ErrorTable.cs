namespace LabRaytracer.Validation;

/// <summary>The error table of a Markdown file, between two markers.</summary>
internal static class ErrorTable
{
    /// <summary>The line before the table.</summary>
    public const string Start = "<!-- error table: RenderScene stress --readme README.md -->";

    /// <summary>The line after the table.</summary>
    public const string End = "<!-- end of the error table -->";

    /// <summary>Tells whether a file is there and has a place for the table.</summary>
    public static bool HasMarkers(string path) => File.Exists(path) && Find(File.ReadAllText(path), out _, out _);

    /// <summary>Replaces the table of a file.</summary>
    public static void Write(string path, StressReport report)
    {
        string text = File.ReadAllText(path);
        if (Find(text, out int first, out int end))
        {
            File.WriteAllText(path, $"{text[..first]}\n{report.ToMarkdown()}{text[end..]}");
        }
    }

    /// <summary>The verdict of each feature in a Markdown text.</summary>
    public static IReadOnlyDictionary<string, string> Verdicts(string text)
    {
        Dictionary<string, string> verdicts = [];
        if (Find(text, out int first, out int end))
        {
            foreach (string[] cells in text[first..end].Split('\n').Select(line => line.Split('|', StringSplitOptions.TrimEntries)))
            {
                if (cells.Length == 7 && cells[1] is not ("feature" or "---"))
                {
                    verdicts[cells[1]] = cells[5];
                }
            }
        }

        return verdicts;
    }

    private static bool Find(string text, out int first, out int end)
    {
        first = text.IndexOf(Start, StringComparison.Ordinal) + Start.Length;
        end = text.IndexOf(End, StringComparison.Ordinal);
        return first >= Start.Length && end >= first;
    }
}
