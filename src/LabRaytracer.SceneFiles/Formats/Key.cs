using System.Text.Json.Nodes;

namespace LabRaytracer;

/// <summary>A key that an object of a scene file may have.</summary>
internal abstract class Key(string name, string description)
{
    public string Name { get; } = name;

    /// <summary>What it means, its unit, for the schema.</summary>
    public string Description { get; } = description;

    public bool IsRequired { get; private init; }

    /// <summary>Tells whether leaving the key out means the same as writing its default.</summary>
    public bool HasDefault { get; private init; }

    public abstract string Allowed { get; }

    /// <summary>Reads the value; null after a mistake.</summary>
    public abstract object? Read(SceneNode node, SceneReading reading);

    /// <summary>The schema of the value, with description and default.</summary>
    public abstract JsonObject Schema(SchemaBuilder schema);

    /// <summary>A key that must be there.</summary>
    public static Key<T> Required<T>(string name, Format<T> format, string description)
        where T : notnull => new(name, description, format, default!) { IsRequired = true };

    /// <summary>A key that may be left out.</summary>
    public static Key<T> Optional<T>(string name, Format<T> format, T value, string description)
        where T : notnull => new(name, description, format, value) { HasDefault = true };

    /// <summary>A key that may be left out and then means something that is no value; ask <see cref="Fields.Has"/> first.</summary>
    public static Key<T> Optional<T>(string name, Format<T> format, string description)
        where T : notnull => new(name, description, format, default!);
}

/// <summary>A key whose value has a type.</summary>
internal sealed class Key<T>(string name, string description, Format<T> format, T value) : Key(name, description)
    where T : notnull
{
    /// <summary>What the key means when it is left out.</summary>
    public T Default { get; } = value;

    public override string Allowed => format.Allowed;

    public override object? Read(SceneNode node, SceneReading reading) => format.TryRead(node, reading, out T? read) ? read : null;

    public override JsonObject Schema(SchemaBuilder schema)
    {
        JsonObject value = format.Schema(schema);
        if (value.ContainsKey("$ref"))
        {
            // Draft 7 ignores what stands beside a reference.
            value = new JsonObject { ["allOf"] = new JsonArray(value) };
        }

        value["description"] = Description;
        if (HasDefault && format.Write(Default) is { } standard)
        {
            value["default"] = standard;
        }

        return value;
    }
}
