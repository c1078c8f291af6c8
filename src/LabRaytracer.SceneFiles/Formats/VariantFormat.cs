using System.Diagnostics.CodeAnalysis;
using System.Text.Json.Nodes;

namespace LabRaytracer;

/// <summary>One of several kinds of objects, told by the value of a key such as "type".</summary>
/// <param name="key">The key.</param>
/// <param name="description">One sentence for the schema.</param>
/// <param name="variants">The common kinds.</param>
/// <param name="others">Finds further kinds: they are not made for files that do without them.</param>
internal sealed class VariantFormat<T>(
    string key, string description, IReadOnlyList<ObjectFormat<T>> variants, Func<IReadOnlyList<ObjectFormat<T>>>? others = null) : Format<T>
    where T : notnull
{
    public override string Allowed => $"an object with '{key}': {Wording.List(Names)}";

    private IEnumerable<string> Names => All.Select(variant => variant.Tag!.Value.Value);

    private IEnumerable<ObjectFormat<T>> All => others is null ? variants : variants.Concat(others());

    public override bool TryRead(SceneNode node, SceneReading reading, [MaybeNullWhen(false)] out T value)
    {
        value = default;
        if (node.Kind != NodeKind.Object)
        {
            return reading.WrongValue(node, Allowed);
        }

        foreach ((SceneNode at, SceneNode content) in node.Members())
        {
            if (at.TextIs(key))
            {
                return TryReadVariant(node, content, reading, out value);
            }
        }

        return reading.Mistake(node, $"the key '{key}' is missing", Wording.List(Names));
    }

    public override JsonObject Schema(SchemaBuilder schema) => new()
    {
        ["description"] = description,
        ["type"] = "object",
        ["required"] = new JsonArray(key),
        ["anyOf"] = new JsonArray([.. All.Select(variant => variant.Schema(schema))]),
    };

    private bool TryReadVariant(SceneNode node, SceneNode tag, SceneReading reading, [MaybeNullWhen(false)] out T value)
    {
        value = default;
        if (tag.Kind != NodeKind.Text)
        {
            return reading.WrongValue(tag, Wording.List(Names));
        }

        foreach (ObjectFormat<T> variant in All)
        {
            if (tag.TextIs(variant.Tag!.Value.Value))
            {
                return variant.TryRead(node, reading, out value);
            }
        }

        string text = tag.Text();
        return reading.Mistake(tag, $"unknown {key} {Wording.Quote(text)}{Wording.Suggestion(text, Names)}", Wording.List(Names));
    }
}
