using System.Diagnostics.CodeAnalysis;
using System.Text.Json.Nodes;

namespace LabRaytracer;

/// <summary>A file that exists, named relative to the scene's folder.</summary>
internal sealed class FileFormat(string what, bool isPicture = false) : Format<NamedFile>
{
    public override string Allowed => $"the path of {what} in the scene's folder or below, with '/' between folders";

    public override bool TryRead(SceneNode node, SceneReading reading, [MaybeNullWhen(false)] out NamedFile value)
    {
        value = null;
        if (node.Kind != NodeKind.Text)
        {
            return reading.WrongValue(node, Allowed);
        }

        string name = node.Text();
        if (reading.Folder.Find(name, reading.Folder.Root, out string path, isPicture) is { } why)
        {
            return reading.Mistake(node, why, Allowed);
        }

        value = new NamedFile(path, Path.Combine(Path.GetDirectoryName(node.Location().File) ?? "", name), node);
        return true;
    }

    public override JsonObject Schema(SchemaBuilder schema) => new() { ["type"] = "string", ["minLength"] = 1 };
}

/// <summary>A file that a scene names.</summary>
/// <param name="Path">The absolute path.</param>
/// <param name="ShownPath">The path for messages: as the scene itself was named.</param>
/// <param name="Node">Where the scene names it.</param>
internal sealed record NamedFile(string Path, string ShownPath, SceneNode Node);
