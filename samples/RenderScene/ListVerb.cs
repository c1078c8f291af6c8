using System.CommandLine;
using System.Text.Json.Nodes;
using LabRaytracer;

namespace RenderScene;

/// <summary>list: the scenes that are here, and what scene files may name.</summary>
internal static class ListVerb
{
    /// <summary>The verb for the command line.</summary>
    public static Command Create(AppConsole console)
    {
        Command command = new("list", "Lists the scenes, and the shapes, mappings, textures, lamps and cameras that scene files may name.");
        command.SetAction(_ =>
        {
            WriteScenes(console.Output);
            WriteWords(console.Output);
            return ExitCode.Done;
        });
        return command;
    }

    private static void WriteScenes(TextWriter writer)
    {
        string folder = SampleScenes.File("");
        writer.WriteLine("scenes:");
        foreach (string path in Directory.EnumerateFiles(folder, "*.json", SearchOption.AllDirectories).Order(StringComparer.Ordinal))
        {
            if (!path.EndsWith(".schema.json", StringComparison.Ordinal))
            {
                writer.WriteLine($"  {path,-38} {SceneDescription.Read(path)}");
            }
        }
    }

    /// <summary>The words come from the schema, which comes from the declarations that read the files.</summary>
    private static void WriteWords(TextWriter writer)
    {
        JsonObject definitions = JsonNode.Parse(SceneSchema.Generate())!["definitions"]!.AsObject();
        Dictionary<string, List<(string Word, string Description)>> kinds = [];
        foreach ((string name, JsonNode? definition) in definitions)
        {
            string key = definition?["properties"]?["shape"]?["const"] is not null ? "shape" : "type";
            if (definition?["properties"]?[key]?["const"]?.GetValue<string>() is { } word)
            {
                string kind = key == "shape" ? "shapes" : Kind(name, word);
                kinds.TryAdd(kind, []);
                kinds[kind].Add((word, definition["description"]?.GetValue<string>() ?? ""));
            }
        }

        foreach ((string kind, List<(string Word, string Description)> words) in kinds)
        {
            writer.WriteLine($"{kind}:");
            foreach ((string word, string description) in words)
            {
                writer.WriteLine($"  {word,-38} {description}");
            }
        }

        JsonNode? mappings = definitions["mapping"]?["anyOf"]?[0]?["enum"];
        writer.WriteLine($"mappings by a word:\n  {string.Join(", ", mappings?.AsArray().Select(word => word!.GetValue<string>()) ?? [])}");
    }

    /// <summary>pointLight, point: lights.</summary>
    private static string Kind(string definition, string word) => definition[Math.Min(word.Length, definition.Length)..].ToLowerInvariant() + "s";
}
