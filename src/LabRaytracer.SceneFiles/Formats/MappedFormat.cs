using System.Diagnostics.CodeAnalysis;
using System.Text.Json.Nodes;

namespace LabRaytracer;

/// <summary>Values written as those of another format and then turned into something else.</summary>
internal sealed class MappedFormat<TFrom, TTo>(Format<TFrom> from, Func<TFrom, TTo> map, Func<TTo, TFrom>? back = null) : Format<TTo>
{
    public override string Allowed => from.Allowed;

    public override bool TryRead(SceneNode node, SceneReading reading, [MaybeNullWhen(false)] out TTo value)
    {
        bool good = from.TryRead(node, reading, out TFrom? read);
        value = good ? map(read!) : default;
        return good;
    }

    public override JsonObject Schema(SchemaBuilder schema) => from.Schema(schema);

    public override JsonNode? Write(TTo value) => back is null ? null : from.Write(back(value));
}
