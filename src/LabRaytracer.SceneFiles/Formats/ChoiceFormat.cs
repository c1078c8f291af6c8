using System.Diagnostics.CodeAnalysis;
using System.Text.Json.Nodes;

namespace LabRaytracer;

/// <summary>One of a few words, each with its meaning.</summary>
/// <param name="words">The words.</param>
/// <param name="values">The meanings, in the same order.</param>
internal sealed class ChoiceFormat<T>(string[] words, T[] values) : Format<T>
    where T : notnull
{
    public ChoiceFormat(params (string Word, T Value)[] choices)
        : this([.. choices.Select(choice => choice.Word)], [.. choices.Select(choice => choice.Value)])
    {
    }

    public override string Allowed => Wording.List(words);

    public override bool TryRead(SceneNode node, SceneReading reading, [MaybeNullWhen(false)] out T value)
    {
        value = default;
        if (node.Kind != NodeKind.Text)
        {
            return reading.WrongValue(node, Allowed);
        }

        string text = node.Text();
        int choice = Array.IndexOf(words, text);
        if (choice >= 0)
        {
            value = values[choice];
            return true;
        }

        return reading.Mistake(node, $"unknown word {Wording.Quote(text)}{Wording.Suggestion(text, words)}", Allowed);
    }

    public override JsonObject Schema(SchemaBuilder schema) => new() { ["enum"] = new JsonArray([.. words.Select(word => JsonValue.Create(word))]) };

    public override JsonNode? Write(T value) => JsonValue.Create(words[Array.FindIndex(values, candidate => candidate.Equals(value))]);
}

/// <summary>Words of an enumeration: its names, the first letter small.</summary>
internal static class ChoiceFormat
{
    /// <summary>All values of an enumeration.</summary>
    /// <remarks>Without generic methods inside: the runtime would compile each of them again for every enumeration, before any scene is read.</remarks>
    public static ChoiceFormat<TEnum> Of<TEnum>()
        where TEnum : struct, Enum => new(Words(typeof(TEnum)), [.. Values(typeof(TEnum)).Cast<TEnum>()]);

    private static string[] Words(Type type) => [.. Enum.GetNames(type).Select(name => char.ToLowerInvariant(name[0]) + name[1..])];

    private static object[] Values(Type type) => [.. Enum.GetNames(type).Select(name => Enum.Parse(type, name))];
}
