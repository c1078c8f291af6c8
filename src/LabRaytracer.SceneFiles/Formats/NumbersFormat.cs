using System.Diagnostics.CodeAnalysis;
using System.Text.Json.Nodes;

namespace LabRaytracer;

/// <summary>A fixed number of finite numbers in brackets: a point, a vector, a matrix.</summary>
/// <param name="count">How many.</param>
/// <param name="allowed">What is allowed, for messages.</param>
/// <param name="make">The value of the numbers; null where they do not fit together.</param>
/// <param name="write">The numbers of a value, for defaults in the schema.</param>
internal sealed class NumbersFormat<T>(int count, string allowed, Func<double[], T?> make, Func<T, double[]> write) : Format<T>
    where T : struct
{
    /// <summary>What each number must be.</summary>
    public NumberFormat Item { get; init; } = NumberFormat.Any;

    public override string Allowed => allowed;

    public override bool TryRead(SceneNode node, SceneReading reading, [MaybeNullWhen(false)] out T value)
    {
        value = default;
        if (node.Kind != NodeKind.Array || node.Count != count)
        {
            return reading.WrongValue(node, allowed);
        }

        double[] numbers = new double[count];
        int next = 0;
        bool good = true;
        foreach (SceneNode item in node.Items())
        {
            good &= Item.TryRead(item, reading, out numbers[next++]);
        }

        if (!good)
        {
            return false;
        }

        T? made = make(numbers);
        value = made ?? default;
        return made.HasValue || reading.WrongValue(node, allowed);
    }

    public override JsonObject Schema(SchemaBuilder schema) => new()
    {
        ["type"] = "array", ["items"] = Item.Schema(schema), ["minItems"] = count, ["maxItems"] = count,
    };

    public override JsonNode? Write(T value) => new JsonArray([.. write(value).Select(number => JsonValue.Create(number))]);
}
