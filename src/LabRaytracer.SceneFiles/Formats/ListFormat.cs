using System.Diagnostics.CodeAnalysis;
using System.Text.Json.Nodes;

namespace LabRaytracer;

/// <summary>Any number of values in brackets.</summary>
internal sealed class ListFormat<T>(Format<T> items, string what) : Format<IReadOnlyList<T>>
{
    public override string Allowed => $"a list of {what} in brackets [ ... ]";

    public override bool TryRead(SceneNode node, SceneReading reading, [MaybeNullWhen(false)] out IReadOnlyList<T> value)
    {
        value = null;
        if (node.Kind != NodeKind.Array)
        {
            return reading.WrongValue(node, Allowed);
        }

        List<T> all = new(node.Count);
        foreach (SceneNode item in node.Items())
        {
            if (items.TryRead(item, reading, out T? read))
            {
                all.Add(read);
            }
        }

        value = all;
        return all.Count == node.Count;
    }

    public override JsonObject Schema(SchemaBuilder schema) => new() { ["type"] = "array", ["items"] = items.Schema(schema) };
}
