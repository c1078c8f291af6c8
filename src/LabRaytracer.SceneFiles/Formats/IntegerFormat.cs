using System.Globalization;
using System.Text.Json.Nodes;

namespace LabRaytracer;

/// <summary>A whole number in a range.</summary>
internal sealed class IntegerFormat(int min, int max) : Format<int>
{
    public override string Allowed => string.Create(CultureInfo.InvariantCulture, $"a whole number from {min} to {max}");

    public override bool TryRead(SceneNode node, SceneReading reading, out int value)
    {
        value = 0;
        if (node.Kind != NodeKind.Number || !node.TryNumber(out double number) || number != Math.Floor(number) || number < min || number > max)
        {
            return reading.WrongValue(node, Allowed);
        }

        value = (int)number;
        return true;
    }

    public override JsonObject Schema(SchemaBuilder schema) => new() { ["type"] = "integer", ["minimum"] = min, ["maximum"] = max };

    public override JsonNode? Write(int value) => JsonValue.Create(value);
}
