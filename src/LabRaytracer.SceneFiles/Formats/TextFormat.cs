using System.Diagnostics.CodeAnalysis;
using System.Text.Json.Nodes;

namespace LabRaytracer;

/// <summary>Any text.</summary>
internal sealed class TextFormat : Format<string>
{
    public static TextFormat Instance { get; } = new();

    public override string Allowed => "text in double quotes";

    public override bool TryRead(SceneNode node, SceneReading reading, [MaybeNullWhen(false)] out string value)
    {
        value = node.Kind == NodeKind.Text ? node.Text() : null;
        return value is not null || reading.WrongValue(node, Allowed);
    }

    public override JsonObject Schema(SchemaBuilder schema) => new() { ["type"] = "string" };

    public override JsonNode? Write(string value) => JsonValue.Create(value);
}
