using System.Diagnostics.CodeAnalysis;
using System.Text.Json.Nodes;

namespace LabRaytracer;

/// <summary>Things with names of the author's choice.</summary>
internal sealed class MapFormat<T>(Format<T> format, Func<SceneReading, Dictionary<string, T?>> known) : Format<IReadOnlyDictionary<string, T?>>
    where T : class
{
    public override string Allowed => "an object { name: ..., name: ... }";

    public override bool TryRead(SceneNode node, SceneReading reading, [MaybeNullWhen(false)] out IReadOnlyDictionary<string, T?> value)
    {
        value = null;
        if (node.Kind != NodeKind.Object)
        {
            return reading.WrongValue(node, Allowed);
        }

        bool good = true;
        Dictionary<string, T?> names = known(reading);
        foreach ((SceneNode key, SceneNode content) in node.Members())
        {
            string name = key.Text();
            if (name.Length == 0 || name[0] == '#')
            {
                good = reading.Mistake(key, "a name must not be empty or start with '#', as colours do", allowed: null);
            }

            reading.NameBeingRead = name;
            good &= format.TryRead(content, reading, out T? read);
            names[name] = read;
            reading.NameBeingRead = "";
        }

        value = names;
        return good;
    }

    public override JsonObject Schema(SchemaBuilder schema) => new()
    {
        ["type"] = "object", ["propertyNames"] = new JsonObject { ["pattern"] = "^[^#]" }, ["additionalProperties"] = format.Schema(schema),
    };
}
