using System.Diagnostics.CodeAnalysis;
using System.Text.Json.Nodes;

namespace LabRaytracer;

/// <summary>An object with known keys.</summary>
/// <param name="name">Name in the schema and in messages, such as "sphere".</param>
/// <param name="description">One sentence for the schema.</param>
/// <param name="keys">The keys.</param>
/// <param name="build">Makes the result when every key is right.</param>
/// <param name="tag">Key and value that tell this kind of object from its siblings; null if there are none.</param>
internal sealed class ObjectFormat<T>(string name, string description, IReadOnlyList<Key> keys, Func<Fields, T?> build, (string Key, string Value)? tag = null) : Format<T>
    where T : notnull
{
    /// <summary>Key and value that tell this kind of object from its siblings.</summary>
    public (string Key, string Value)? Tag => tag;

    public override string Allowed => $"an object {{ {Wording.List(Names)} }}";

    private IEnumerable<string> Names => keys.Select(key => key.Name).Order(StringComparer.Ordinal);

    public override bool TryRead(SceneNode node, SceneReading reading, [MaybeNullWhen(false)] out T value)
    {
        value = default;
        if (node.Kind != NodeKind.Object)
        {
            return reading.WrongValue(node, Allowed);
        }

        Fields fields = new(node, reading);
        return ReadKeys(node, reading, fields) && TryBuild(fields, out value);
    }

    public override JsonObject Schema(SchemaBuilder schema) => schema.Define(name, () =>
    {
        JsonObject properties = [];
        if (tag is { } kind)
        {
            properties[kind.Key] = new JsonObject { ["const"] = kind.Value, ["description"] = description };
        }

        foreach (Key key in keys)
        {
            properties[key.Name] = key.Schema(schema);
        }

        JsonArray required = new([.. keys.Where(key => key.IsRequired).Select(key => JsonValue.Create(key.Name))]);
        if (tag is not null)
        {
            required.Insert(0, tag.Value.Key);
        }

        JsonObject result = new()
        {
            ["type"] = "object", ["description"] = description, ["additionalProperties"] = false, ["properties"] = properties,
        };
        if (required.Count > 0)
        {
            result["required"] = required;
        }

        return result;
    });

    // In the order of the declaration, not of the file: names are known before they are used.
    private bool ReadKeys(SceneNode node, SceneReading reading, Fields fields)
    {
        List<(SceneNode Key, SceneNode Content)> members = [.. node.Members()];
        bool good = true;
        foreach ((SceneNode at, _) in members)
        {
            if (!IsKnown(at))
            {
                good = reading.Mistake(at, $"unknown key{Wording.Suggestion(at.Text(), Names)}", Wording.List(Names));
            }
        }

        foreach (Key key in keys)
        {
            int index = IndexOf(members, key);
            if (index < 0)
            {
                good &= !key.IsRequired || reading.Mistake(node, $"the key '{key.Name}' is missing", key.Allowed);
            }
            else if (key.Read(members[index].Content, reading) is { } read)
            {
                fields.Add(key, members[index].Content, read);
            }
            else
            {
                good = false;
            }
        }

        return good;
    }

    private bool IsKnown(SceneNode name)
    {
        bool known = tag is { } kind && name.TextIs(kind.Key);
        for (int i = 0; !known && i < keys.Count; i++)
        {
            known = name.TextIs(keys[i].Name);
        }

        return known;
    }

    /// <summary>The first member with a key; -1 if there is none.</summary>
    private static int IndexOf(List<(SceneNode Key, SceneNode Content)> members, Key key)
    {
        for (int i = 0; i < members.Count; i++)
        {
            if (members[i].Key.TextIs(key.Name))
            {
                return i;
            }
        }

        return -1;
    }

    // What formats do not check, constructors of the library do.
    private bool TryBuild(Fields fields, [MaybeNullWhen(false)] out T value)
    {
        try
        {
            value = build(fields);
        }
        catch (ArgumentException failure)
        {
            value = default;
            return fields.Reading.Mistake(fields.Node, Wording.Reason(failure), allowed: null);
        }

        if (value is ITexture or Material or Light or Camera)
        {
            fields.Reading.Note(value, fields.Node);
        }

        return value is not null && !fields.Failed;
    }
}
