using System.Diagnostics.CodeAnalysis;
using System.Text.Json.Nodes;

namespace LabRaytracer;

/// <summary>The name of something that the file describes elsewhere.</summary>
internal sealed class NameFormat<T>(string what, string section, Func<SceneReading, NamedThings<T>> known) : Format<T>
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
        NamedThings<T> things = known(reading);
        if (things.FindCircle(name) is { } circle)
        {
            return reading.Mistake(node, $"the {what} {Wording.Quote(name)} needs itself: {circle}", AllowedNames(things));
        }

        if (!things.Has(name))
        {
            return reading.Mistake(node, $"there is no {what} {Wording.Quote(name)}{Wording.Suggestion(name, things.Usable)}", AllowedNames(things));
        }

        if (things.IsTooDeep)
        {
            return reading.Mistake(node, "too many names need each other", $"{NamedThings<T>.MostNested} in a row, more where each stands above the one that needs it");
        }

        // A thing with a mistake in it was reported where it is described.
        value = things.Read(name);
        return value is not null;
    }

    private string AllowedNames(NamedThings<T> things) => things.Usable.Any() ? Wording.List(things.Usable) : $"names in '{section}', which {(things.IsEmpty ? "is empty" : "has no other")}";

    public override JsonObject Schema(SchemaBuilder schema) => new() { ["type"] = "string" };
}
