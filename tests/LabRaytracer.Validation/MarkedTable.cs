namespace LabRaytracer.Validation;

/// <summary>A table of a Markdown file, between two lines that mark its place.</summary>
/// <param name="Start">The line before the table.</param>
/// <param name="End">The line after the table.</param>
internal sealed record MarkedTable(string Start, string End)
{
    /// <summary>The short form of the error table.</summary>
    public static MarkedTable Errors { get; } = new("<!-- error table: RenderScene stress --readme README.md -->", "<!-- end of the error table -->");

    /// <summary>The long form of the error table.</summary>
    public static MarkedTable LongForm { get; } = new("<!-- long form: RenderScene stress --long --readme README.md -->", "<!-- end of the long form -->");

    /// <summary>Whole renders in each precision.</summary>
    public static MarkedTable Renders { get; } = new("<!-- renders: RenderScene stress --renders --readme README.md -->", "<!-- end of the renders -->");

    /// <summary>Tells whether a file is there and has a place for the table.</summary>
    public bool IsIn(string path) => File.Exists(path) && Find(File.ReadAllText(path), out _, out _);

    /// <summary>Replaces the table of a file.</summary>
    public void Write(string path, string table)
    {
        string text = File.ReadAllText(path);
        if (Find(text, out int first, out int end))
        {
            File.WriteAllText(path, $"{text[..first]}\n{table}{text[end..]}");
        }
    }

    /// <summary>The cells of the lines of the table in a Markdown text, without the two head lines.</summary>
    public IReadOnlyList<string[]> Lines(string text) => Find(text, out int first, out int end)
        ? [.. text[first..end].Split('\n').Where(line => line.StartsWith('|')).Skip(2).Select(line => line.Trim('|', ' ').Split('|', StringSplitOptions.TrimEntries))]
        : [];

    private bool Find(string text, out int first, out int end)
    {
        first = text.IndexOf(Start, StringComparison.Ordinal) + Start.Length;
        end = text.IndexOf(End, StringComparison.Ordinal);
        return first >= Start.Length && end >= first;
    }
}
