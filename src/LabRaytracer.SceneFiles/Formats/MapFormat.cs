using System.Diagnostics.CodeAnalysis;
using System.Text.Json.Nodes;

namespace LabRaytracer;

/// <summary>Things with names of the author's choice.</summary>
internal sealed class MapFormat<T>(Format<T> format, Func<SceneReading, NamedThings<T>> known) : Format<NamedThings<T>>
    where T : class
{
    public override string Allowed => "an object { name: ..., name: ... }";

    public override bool TryRead(SceneNode node, SceneReading reading, [MaybeNullWhen(false)] out NamedThings<T> value)
    {
        value = null;
        if (node.Kind != NodeKind.Object)
        {
            return reading.WrongValue(node, Allowed);
        }

        bool good = true;
        NamedThings<T> things = known(reading);
        List<string> names = [];
        foreach ((SceneNode key, SceneNode content) in node.Members())
        {
            string name = key.Text();
            if (name.Length == 0 || name[0] == '#')
            {
                good = reading.Mistake(key, "a name must not be empty or start with '#', as colours do", allowed: null);
            }

            things.Add(name, () => Read(name, content, reading));
            names.Add(name);
        }

        foreach (string name in names)
        {
            good &= things.Read(name) is not null;
        }

        value = things;
        return good;
    }

    private T? Read(string name, SceneNode content, SceneReading reading)
    {
        string before = reading.NameBeingRead;
        reading.NameBeingRead = name;
        format.TryRead(content, reading, out T? read);
        reading.NameBeingRead = before;
        return read;
    }

    public override JsonObject Schema(SchemaBuilder schema) => new()
    {
        ["type"] = "object", ["propertyNames"] = new JsonObject { ["pattern"] = "^[^#]" }, ["additionalProperties"] = format.Schema(schema),
    };
}
