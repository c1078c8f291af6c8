using System.Globalization;
using System.Text;
using System.Text.Json.Nodes;

namespace LabRaytracer.PublicApi.Tests;

/// <summary>docs/scene-format.md: tables made of the schema, which is made of the declarations that read scene files.</summary>
internal static class SceneFormatText
{
    private const string Head = """
        # Scene files
        A scene is a JSON file; comments and trailing commas are allowed. Lengths are in scene units, the world is right-handed with +Y up, colours are linear
        unless written as "#rrggbb" (sRGB), angles are degrees. Files that a scene names are relative to its own folder. Every mistake is reported with
        file:line:column, unknown keys included. `scenes/` has an example of each feature; `scenes/scene.schema.json` gives completion in editors.

        This page is generated: `LABRAYTRACER_UPDATE_PUBLIC_API=1 dotnet test tests/LabRaytracer.PublicApi.Tests` writes it again.

        """;

    /// <summary>The whole page.</summary>
    public static string Create()
    {
        JsonObject schema = JsonNode.Parse(SceneSchema.Generate())!.AsObject();
        StringBuilder text = new(Head.ReplaceLineEndings("\n"));
        Section(text, "scene", schema);
        foreach ((string name, JsonNode? definition) in schema["definitions"]!.AsObject())
        {
            Section(text, name, definition!.AsObject());
        }

        return text.ToString();
    }

    private static void Section(StringBuilder text, string name, JsonObject schema)
    {
        text.Append("\n## ").Append(name).Append('\n');
        if (schema["description"] is { } description)
        {
            text.Append(description.GetValue<string>()).Append("\n\n");
        }

        if (schema["properties"] is not JsonObject properties)
        {
            text.Append(Kind(schema)).Append(".\n");
            return;
        }

        HashSet<string> required = [.. (schema["required"] as JsonArray ?? []).Select(key => key!.GetValue<string>())];
        text.Append("| key | value | default | meaning |\n|---|---|---|---|\n");
        foreach ((string key, JsonNode? node) in properties.Where(item => item.Key != "$schema"))
        {
            JsonObject property = node!.AsObject();
            string otherwise = required.Contains(key) ? "required" : property["default"] is { } value ? $"`{value.ToJsonString()}`" : "";
            text.Append(CultureInfo.InvariantCulture, $"| `{key}` | {Kind(property)} | {otherwise} | {property["description"]} |\n");
        }
    }

    /// <summary>What a value may be, in words.</summary>
    private static string Kind(JsonObject schema)
    {
        if (schema["$ref"] is { } reference)
        {
            string name = reference.GetValue<string>().Split('/')[^1];
            return $"[{name}](#{name.ToLowerInvariant()})";
        }

        if ((schema["anyOf"] ?? schema["oneOf"] ?? schema["allOf"]) is JsonArray choices)
        {
            return string.Join(" or ", choices.Select(choice => Kind(choice!.AsObject())));
        }

        if (schema["const"] is { } only)
        {
            return $"`{only.ToJsonString()}`";
        }

        if (schema["enum"] is JsonArray words)
        {
            return string.Join(", ", words.Select(word => $"`{word!.ToJsonString()}`"));
        }

        return schema["type"]?.GetValue<string>() switch
        {
            "array" => $"list of {Count(schema)}{Kind(schema["items"]?.AsObject() ?? [])}",
            "object" when schema["additionalProperties"] is JsonObject values => $"names, each with {Kind(values)}",
            "string" when schema["pattern"] is { } pattern => $"string matching `{pattern.GetValue<string>().Replace("|", "\\|", StringComparison.Ordinal)}`",
            { } type => type + Range(schema),
            null => "any",
        };
    }

    private static string Count(JsonObject schema) => schema["minItems"] is { } least && schema["maxItems"] is { } most
        ? least.ToJsonString() == most.ToJsonString() ? $"{least} x " : $"{least} to {most} x "
        : "";

    private static string Range(JsonObject schema)
    {
        if (schema["minimum"] is { } from && schema["maximum"] is { } to)
        {
            return $" in [{from}, {to}]";
        }

        string low = schema["minimum"] is { } least ? $" at least {least}" : schema["exclusiveMinimum"] is { } above ? $" above {above}" : "";
        string high = schema["maximum"] is { } most ? $" at most {most}" : schema["exclusiveMaximum"] is { } below ? $" below {below}" : "";
        return low + high;
    }
}
