using System.Text.Json.Nodes;
using RenderScene;

namespace LabRaytracer.Tests.SceneFiles;

/// <summary>Scene files made at random of what the schema allows: whatever keys it has or will have, together.</summary>
internal sealed class RandomScene
{
    private const int Names = 3;
    private static readonly JsonObject s_schema = JsonNode.Parse(File.ReadAllText(SampleScenes.File("scene.schema.json")))!.AsObject();
    private static readonly string[] s_pictures = ["earth-2048x1024.png", "leaf.png", "test-8x4.png", "badge.png", "crate.png", "evening.hdr", "bricks-height.png", "studs-normal.png"];
    private readonly Random _random;

    /// <summary>Number of the first name that may be used: a texture names only those below it, so that none needs itself.</summary>
    private int _firstName;

    private RandomScene(int seed) => _random = new Random(seed);

    /// <summary>The text of a scene, small; pictures are those of the folder of scenes. Some are refused, as not all that is not allowed stands in the schema.</summary>
    public static string Create(int seed) => new RandomScene(seed).Root().ToJsonString();

    private JsonObject Root()
    {
        JsonObject keys = s_schema["properties"]!.AsObject();
        JsonNode Value(string key) => Of(keys[key]!, 1, key)!;
        JsonObject render = Value("render").AsObject(), camera = Value("camera").AsObject();
        foreach ((string key, JsonNode value) in new (string, JsonNode)[] { ("width", Pick(16, 23, 40)), ("height", Pick(9, 16, 17)), ("samples", Pick(1, 1, 4)), ("edgeSamples", Pick(1, 4)), ("maxSamples", 16), ("errorBudget", Pick(0, 0, 0, 1)) })
        {
            render[key] = value;
        }

        if (_random.Next(5) > 0)
        {
            // Most cameras look at the middle, where things are.
            camera["eye"] = new JsonArray(Between(-4, 4), Between(0, 4), Between(3, 8));
            camera.Remove("target");
            camera.Remove("up");
        }

        JsonObject root = new() { ["render"] = render, ["camera"] = camera, ["textures"] = new JsonObject(), ["materials"] = new JsonObject() };
        for (int i = 0; i < Names; i++)
        {
            _firstName = i + 1;
            root["textures"]!["t" + i] = Of(keys["textures"]!["additionalProperties"]!, 2, "");
            _firstName = 0;
            root["materials"]!["t" + i] = Of(keys["materials"]!["additionalProperties"]!, 2, "");
        }

        root["objects"] = new JsonArray([.. Enumerable.Range(0, _random.Next(1, 6)).Select(_ => Of(keys["objects"]!["items"]!, 1, "")).Where(shape => (string?)shape!["shape"] != "mesh")]);
        root["lights"] = new JsonArray([.. Enumerable.Range(0, _random.Next(4)).Select(_ => Of(keys["lights"]!["items"]!, 1, ""))]);
        foreach (string key in new[] { "background", "backgroundRotation" }.Where(_ => _random.Next(5) < 2))
        {
            root[key] = Value(key);
        }

        return root;
    }

    /// <summary>A value that fits a part of the schema.</summary>
    /// <param name="part">The part.</param>
    /// <param name="depth">How deep the value lies: the deeper, the simpler.</param>
    /// <param name="key">Its key, or that of the list it is in.</param>
    private JsonNode? Of(JsonNode part, int depth, string key)
    {
        if ((string?)part["$ref"] is { } reference)
        {
            return reference.EndsWith("/transform", StringComparison.Ordinal) ? Transform(key) : Of(s_schema["definitions"]![reference[(reference.LastIndexOf('/') + 1)..]]!, depth, key);
        }

        if (part["allOf"] is JsonArray { Count: 1 } all)
        {
            return Of(all[0]!, depth, key);
        }

        if (part["const"] is { } only)
        {
            return only.DeepClone();
        }

        if (part["enum"] is JsonArray words)
        {
            // The filter of references would take most of the time.
            JsonNode word = words[_random.Next(words.Count)]!;
            return (string?)word == "area" && words.Count > 2 ? "ewa" : word.DeepClone();
        }

        if (part["anyOf"] is JsonArray choices)
        {
            JsonNode[] simple = [.. choices.Where(choice => depth < 5 || choice!["anyOf"] is null).OfType<JsonNode>()];
            return Of(simple.Length > 0 ? simple[_random.Next(simple.Length)] : choices[_random.Next(choices.Count)]!, depth, key);
        }

        return (string?)part["type"] switch
        {
            "number" => Number(part),
            "integer" => key == "samples" ? _random.Next(1, 5) : _random.Next(Math.Max(Limit(part, "inimum", -5), -5), Math.Min(Limit(part, "aximum", 9), 9) + 1),
            "boolean" => _random.Next(3) > 0,
            "string" => Text(part, key),
            "array" => List(part, depth, key),
            _ => Object(part, depth),
        };
    }

    private JsonObject Object(JsonNode part, int depth)
    {
        JsonObject result = [];
        string[] required = [.. (part["required"] as JsonArray ?? []).Select(key => (string)key!)];
        double share = (0.25 + (0.3 * _random.NextDouble())) / (1 + Math.Max(0, depth - 3));
        foreach ((string key, JsonNode? value) in part["properties"]?.AsObject() ?? [])
        {
            bool isLeftOut = key is "$schema" or "name" or "inside" or "place" or "innerDegrees" or "normals" or "uvs" or "tubeRadius";
            if (required.Contains(key) || (!isLeftOut && _random.NextDouble() < share))
            {
                result[key] = Of(value!, depth + 1, key);
            }
        }

        return result;
    }

    private JsonArray List(JsonNode part, int depth, string key)
    {
        int least = Math.Max((int?)part["minItems"] ?? 0, key == "ramp" ? 1 : 0), most = Math.Min((int?)part["maxItems"] ?? least + 2, Math.Max(least, depth > 3 ? 2 : 4));
        return [.. Enumerable.Range(0, _random.Next(least, most + 1)).Select(_ => Of(part["items"]!, depth + 1, key))];
    }

    private JsonNode Text(JsonNode part, string key)
    {
        if (key == "file")
        {
            return "textures/" + s_pictures[_random.Next(s_pictures.Length)];
        }

        bool isColor = ((string?)part["pattern"])?.StartsWith("^#", StringComparison.Ordinal) == true;
        return isColor ? $"#{_random.Next(1 << 24):x6}"
            : _firstName < Names ? $"t{_random.Next(_firstName, Names)}"
            : new JsonObject { ["type"] = "image", ["file"] = Text(part, "file"), ["filter"] = "ewa" };
    }

    /// <summary>Mostly ordinary numbers, now and then simple, large, small or absurd ones.</summary>
    private double Number(JsonNode part)
    {
        double least = Bound(part, "inimum", double.NegativeInfinity), most = Bound(part, "aximum", double.PositiveInfinity);
        double sign = _random.Next(2) == 0 ? 1 : -1;
        double value = _random.NextDouble() switch
        {
            < 0.15 => Pick(0, 1, -1, 2),
            < 0.8 => Between(-3, 3),
            < 0.93 => sign * Math.Pow(10, Between(-4, 3)),
            _ => sign * Math.Pow(10, Between(-30, 12)),
        };
        value = value <= least ? Math.Abs(value) : value;
        return value > least && value < most ? value : double.IsFinite(least) && double.IsFinite(most) ? Between(least, most) : 1;
    }

    /// <summary>A step of a transform: all that its parts allow would mostly be refused, as a step does one thing.</summary>
    private JsonObject Transform(string key) => (key is "rotation" or "backgroundRotation" ? 0 : _random.Next(4)) switch
    {
        0 => new JsonObject { ["rotateDegrees"] = Between(-400, 400), ["axis"] = new JsonArray(Between(-1, 1), Between(-1, 1), Between(0.1, 1)) },
        1 => new JsonObject { ["translate"] = new JsonArray(Between(-2, 2), Between(-2, 2), Between(-2, 2)) },
        2 => new JsonObject { ["scale"] = new JsonArray(Between(0.1, 2), Between(-2, -0.1), Between(0.1, 2)) },
        _ => new JsonObject { ["matrix"] = new JsonArray([.. Enumerable.Range(0, 12).Select(_ => JsonValue.Create(Between(-1, 1)))]) },
    };

    private double Between(double least, double most) => least + (_random.NextDouble() * (most - least));

    private int Pick(params ReadOnlySpan<int> values) => values[_random.Next(values.Length)];

    private static double Bound(JsonNode part, string word, double none) =>
        (double?)part["m" + word] ?? (double?)part["exclusiveM" + word] ?? none;

    private static int Limit(JsonNode part, string word, int none) => (int)Math.Clamp(Bound(part, word, none), -1000, 1000);
}
