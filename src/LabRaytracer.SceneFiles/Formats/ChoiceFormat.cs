using System.Diagnostics.CodeAnalysis;
using System.Text.Json.Nodes;

namespace LabRaytracer;

/// <summary>One of a few words, each with its meaning.</summary>
internal sealed class ChoiceFormat<T>(params (string Word, T Value)[] choices) : Format<T>
    where T : notnull
{
    public override string Allowed => Wording.List(Words);

    private IEnumerable<string> Words => choices.Select(choice => choice.Word);

    public override bool TryRead(SceneNode node, SceneReading reading, [MaybeNullWhen(false)] out T value)
    {
        value = default;
        if (node.Kind != NodeKind.Text)
        {
            return reading.WrongValue(node, Allowed);
        }

        string text = node.Text();
        foreach ((string word, T meaning) in choices)
        {
            if (word == text)
            {
                value = meaning;
                return true;
            }
        }

        return reading.Mistake(node, $"unknown word {Wording.Quote(text)}{Wording.Suggestion(text, Words)}", Allowed);
    }

    public override JsonObject Schema(SchemaBuilder schema) => new() { ["enum"] = new JsonArray([.. Words.Select(word => JsonValue.Create(word))]) };

    public override JsonNode? Write(T value) => JsonValue.Create(choices.First(choice => choice.Value.Equals(value)).Word);
}

/// <summary>Words of an enumeration: its names, the first letter small.</summary>
internal static class ChoiceFormat
{
    /// <summary>All values of an enumeration.</summary>
    public static ChoiceFormat<TEnum> Of<TEnum>()
        where TEnum : struct, Enum => new([.. Enum.GetValues<TEnum>().Select(value => (Camel(value.ToString()), value))]);

    private static string Camel(string name) => char.ToLowerInvariant(name[0]) + name[1..];
}
