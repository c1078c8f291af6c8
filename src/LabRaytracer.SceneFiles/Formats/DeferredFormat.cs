using System.Diagnostics.CodeAnalysis;
using System.Text.Json.Nodes;

namespace LabRaytracer;

/// <summary>A format that is found when it is first used: for values that contain values of their own kind.</summary>
internal sealed class DeferredFormat<T>(Func<Format<T>> find) : Format<T>
{
    public override string Allowed => find().Allowed;

    public override bool TryRead(SceneNode node, SceneReading reading, [MaybeNullWhen(false)] out T value) => find().TryRead(node, reading, out value);

    public override JsonObject Schema(SchemaBuilder schema) => find().Schema(schema);

    public override JsonNode? Write(T value) => find().Write(value);
}
