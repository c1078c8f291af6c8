using System.Diagnostics.CodeAnalysis;
using System.Text.Json.Nodes;

namespace LabRaytracer;

/// <summary>A file that exists, named relative to the scene's folder.</summary>
internal sealed class FileFormat(string what) : Format<SceneFilePath>
{
    public override string Allowed => $"the path of {what}, relative to the scene's folder, with '/' between folders";

    public override bool TryRead(SceneNode node, SceneReading reading, [MaybeNullWhen(false)] out SceneFilePath value)
    {
        value = null;
        if (node.Kind != NodeKind.Text)
        {
            return reading.WrongValue(node, Allowed);
        }

        string name = node.Text();
        if (SceneFilePath.Refusal(name, reading.Options.AllowOutsidePaths) is { } refusal)
        {
            return reading.Mistake(node, $"{Wording.Quote(name)} {refusal}", Allowed);
        }

        string path = Path.GetFullPath(Path.Combine(reading.Folder, name));
        if (!File.Exists(path))
        {
            string why = Directory.Exists(path) ? "is a folder" : $"does not exist{Wording.Suggestion(Path.GetFileName(name), Neighbours(path))}";
            return reading.Mistake(node, $"the file {Wording.Quote(name)} {why}", Allowed);
        }

        value = new SceneFilePath(name, path, node);
        return true;
    }

    public override JsonObject Schema(SchemaBuilder schema) => new() { ["type"] = "string", ["minLength"] = 1 };

    private static IEnumerable<string> Neighbours(string path)
    {
        string? folder = Path.GetDirectoryName(path);
        try
        {
            return Directory.Exists(folder) ? [.. Directory.EnumerateFiles(folder).Take(1000).Select(file => Path.GetFileName(file))] : [];
        }
        catch (Exception failure) when (failure is IOException or UnauthorizedAccessException)
        {
            return [];
        }
    }
}
