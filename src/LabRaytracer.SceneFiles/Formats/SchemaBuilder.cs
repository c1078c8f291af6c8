using System.Text.Json.Nodes;

namespace LabRaytracer;

/// <summary>Collects the definitions of a JSON schema, so that each kind of object is described once.</summary>
internal sealed class SchemaBuilder
{
    private readonly SortedDictionary<string, JsonObject?> _definitions = new(StringComparer.Ordinal);

    /// <summary>A reference to a definition, which is made when it is first asked for.</summary>
    public JsonObject Define(string name, Func<JsonObject> make)
    {
        if (_definitions.TryAdd(name, null))
        {
            _definitions[name] = make();
        }

        return new JsonObject { ["$ref"] = $"#/definitions/{name}" };
    }

    /// <summary>All definitions, by name.</summary>
    public JsonObject Definitions() => new(_definitions.Select(entry => KeyValuePair.Create(entry.Key, (JsonNode?)entry.Value)));
}
