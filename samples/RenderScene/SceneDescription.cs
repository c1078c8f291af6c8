namespace RenderScene;

/// <summary>What a scene shows, in one line: the comment at the top of its file.</summary>
internal static class SceneDescription
{
    /// <summary>The first comment line of a file, or nothing.</summary>
    public static string Read(string path) =>
        File.ReadLines(path).Take(3).Select(line => line.Trim()).FirstOrDefault(line => line.StartsWith("//", StringComparison.Ordinal))?[2..].Trim() ?? "";
}
