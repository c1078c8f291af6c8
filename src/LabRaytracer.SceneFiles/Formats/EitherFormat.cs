using System.Diagnostics.CodeAnalysis;
using System.Text.Json.Nodes;

namespace LabRaytracer;

/// <summary>Values that may be written in several ways, told apart by what they are: a number, a text, a list, an object.</summary>
internal sealed class EitherFormat<T>(string allowed, params (NodeKind Kind, Format<T> Format)[] ways) : Format<T>
{
    /// <summary>Name in the schema, for values that many keys share; null to repeat them.</summary>
    public string? Name { get; init; }

    public override string Allowed => allowed;

    public override bool TryRead(SceneNode node, SceneReading reading, [MaybeNullWhen(false)] out T value)
    {
        foreach ((NodeKind kind, Format<T> format) in ways)
        {
            if (kind == node.Kind)
            {
                return format.TryRead(node, reading, out value);
            }
        }

        value = default;
        return reading.WrongValue(node, allowed);
    }

    public override JsonObject Schema(SchemaBuilder schema) => Name is null ? Ways(schema) : schema.Define(Name, () => Ways(schema));

    public override JsonNode? Write(T value) => ways.Select(way => way.Format.Write(value)).FirstOrDefault(written => written is not null);

    private JsonObject Ways(SchemaBuilder schema) => new() { ["anyOf"] = new JsonArray([.. ways.Select(way => way.Format.Schema(schema))]) };
}
