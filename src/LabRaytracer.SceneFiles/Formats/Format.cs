using System.Diagnostics.CodeAnalysis;
using System.Text.Json.Nodes;

namespace LabRaytracer;

/// <summary>What a value of a scene file may look like: read, and described in the schema, by one declaration.</summary>
/// <remarks>Immutable, thread safe.</remarks>
internal abstract class Format<T>
{
    /// <summary>What is allowed, in a few words, for messages.</summary>
    public abstract string Allowed { get; }

    /// <summary>Reads a value; a mistake is noted in <paramref name="reading"/>, and the result is false.</summary>
    public abstract bool TryRead(SceneNode node, SceneReading reading, [MaybeNullWhen(false)] out T value);

    /// <summary>The JSON schema of such values.</summary>
    public abstract JsonObject Schema(SchemaBuilder schema);

    /// <summary>A default as it would stand in a file; null if it cannot be written as a value.</summary>
    public virtual JsonNode? Write(T value) => null;
}
