using System.Diagnostics.CodeAnalysis;
using System.Text.Json.Nodes;

namespace LabRaytracer;

/// <summary>The name of something that the file describes elsewhere.</summary>
internal sealed class NameFormat<T>(string what, string section, Func<SceneReading, Dictionary<string, T?>> known) : Format<T>
    where T : class
{
    public override string Allowed => $"the name of a {what}";

    public override bool TryRead(SceneNode node, SceneReading reading, [MaybeNullWhen(false)] out T value)
    {
        value = null;
        if (node.Kind != NodeKind.Text)
        {
            return reading.WrongValue(node, Allowed);
        }

        string name = node.Text();
        Dictionary<string, T?> names = known(reading);
        if (names.TryGetValue(name, out value))
        {
            // A thing with a mistake in it was reported where it is described.
            return value is not null;
        }

        string allowed = names.Count == 0 ? $"names in '{section}', which is empty" : Wording.List(names.Keys);
        return reading.Mistake(node, $"there is no {what} {Wording.Quote(name)}{Wording.Suggestion(name, names.Keys)}", allowed);
    }

    public override JsonObject Schema(SchemaBuilder schema) => new() { ["type"] = "string" };
}
