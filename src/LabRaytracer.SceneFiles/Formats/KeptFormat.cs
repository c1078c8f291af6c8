using System.Diagnostics.CodeAnalysis;
using System.Text.Json.Nodes;

namespace LabRaytracer;

/// <summary>Values that later parts of the file refer to: they are kept once they are read.</summary>
internal sealed class KeptFormat<T>(Format<T> format, Action<SceneReading, T> keep) : Format<T>
{
    public override string Allowed => format.Allowed;

    public override bool TryRead(SceneNode node, SceneReading reading, [MaybeNullWhen(false)] out T value)
    {
        bool good = format.TryRead(node, reading, out value);
        if (good)
        {
            keep(reading, value!);
        }

        return good;
    }

    public override JsonObject Schema(SchemaBuilder schema) => format.Schema(schema);

    public override JsonNode? Write(T value) => format.Write(value);
}
