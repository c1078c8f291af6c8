using System.Text.Encodings.Web;
using System.Text.Json;
using System.Text.Json.Nodes;

namespace LabRaytracer;

/// <summary>The JSON schema of scene files: what editors use to complete keys, show descriptions and check values.</summary>
/// <remarks>Made of the same declarations that read the files. Thread safe.</remarks>
public static class SceneSchema
{
    private static readonly JsonSerializerOptions s_layout = new()
    {
        WriteIndented = true, NewLine = "\n", Encoder = JavaScriptEncoder.UnsafeRelaxedJsonEscaping,
    };

    /// <summary>The schema (JSON Schema draft 7) as text with LF line ends, ending with one.</summary>
    public static string Generate()
    {
        SchemaBuilder builder = new();
        JsonObject root = new()
        {
            ["$schema"] = "http://json-schema.org/draft-07/schema#",
            ["title"] = "LabRaytracer scene",
            ["allowComments"] = true,
            ["allowTrailingCommas"] = true,
        };
        RootFormat.Scene.Schema(builder);
        JsonObject definitions = builder.Definitions();
        JsonObject scene = definitions["scene"]!.AsObject();
        definitions.Remove("scene");
        foreach ((string name, JsonNode? value) in scene)
        {
            root[name] = value?.DeepClone();
        }

        root["definitions"] = definitions;
        return root.ToJsonString(s_layout) + "\n";
    }
}
