using System.Text.Json.Nodes;

namespace LabRaytracer;

/// <summary>true or false.</summary>
internal sealed class SwitchFormat : Format<bool>
{
    public static SwitchFormat Instance { get; } = new();

    public override string Allowed => "true, false";

    public override bool TryRead(SceneNode node, SceneReading reading, out bool value)
    {
        value = node.Kind == NodeKind.True;
        return node.Kind is NodeKind.True or NodeKind.False || reading.WrongValue(node, Allowed);
    }

    public override JsonObject Schema(SchemaBuilder schema) => new() { ["type"] = "boolean" };

    public override JsonNode? Write(bool value) => JsonValue.Create(value);
}
