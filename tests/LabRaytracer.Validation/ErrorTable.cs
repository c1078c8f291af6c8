namespace LabRaytracer.Validation;

/// <summary>The error tables of a Markdown file, short form and long form, each between two markers.</summary>
internal static class ErrorTable
{
    /// <summary>The line before a table.</summary>
    public static string Start(bool isLong) => isLong
        ? "<!-- long form: RenderScene stress --long --readme README.md -->"
        : "<!-- error table: RenderScene stress --readme README.md -->";

    /// <summary>The line after a table.</summary>
    public static string End(bool isLong) => isLong ? "<!-- end of the long form -->" : "<!-- end of the error table -->";

    /// <summary>Tells whether a file is there and has a place for a table.</summary>
    public static bool HasMarkers(string path, bool isLong) => File.Exists(path) && Find(File.ReadAllText(path), isLong, out _, out _);

    /// <summary>Replaces the table of a file.</summary>
    public static void Write(string path, StressReport report)
    {
        string text = File.ReadAllText(path);
        if (Find(text, report.Options.IsLong, out int first, out int end))
        {
            string summary = report.Options.IsLong ? report.Summary() + "\n" : "";
            File.WriteAllText(path, $"{text[..first]}\n{summary}{report.ToMarkdown()}{text[end..]}");
        }
    }

    /// <summary>The verdict of each feature of the short form in a Markdown text.</summary>
    public static IReadOnlyDictionary<string, string> Verdicts(string text)
    {
        Dictionary<string, string> verdicts = [];
        if (Find(text, false, out int first, out int end))
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

    private static bool Find(string text, bool isLong, out int first, out int end)
    {
        string start = Start(isLong);
        first = text.IndexOf(start, StringComparison.Ordinal) + start.Length;
        end = text.IndexOf(End(isLong), StringComparison.Ordinal);
        return first >= start.Length && end >= first;
    }
}
