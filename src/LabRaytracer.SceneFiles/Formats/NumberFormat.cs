using System.Globalization;
using System.Text.Json.Nodes;

namespace LabRaytracer;

/// <summary>A finite number, perhaps in a range.</summary>
internal sealed class NumberFormat : Format<double>
{
    /// <summary>Any finite number.</summary>
    public static NumberFormat Any { get; } = new();

    /// <summary>Above 0.</summary>
    public static NumberFormat Positive { get; } = new() { Above = 0 };

    /// <summary>0 or more.</summary>
    public static NumberFormat NotNegative { get; } = new() { Min = 0 };

    /// <summary>0 to 1.</summary>
    public static NumberFormat Share { get; } = new() { Min = 0, Max = 1 };

    /// <summary>Smallest number, included.</summary>
    public double Min { get; init; } = double.NegativeInfinity;

    /// <summary>Largest number, included.</summary>
    public double Max { get; init; } = double.PositiveInfinity;

    /// <summary>Lower end, excluded.</summary>
    public double Above { get; init; } = double.NegativeInfinity;

    /// <summary>Upper end, excluded.</summary>
    public double Below { get; init; } = double.PositiveInfinity;

    public override string Allowed
    {
        get
        {
            double low = Math.Max(Min, Above), high = Math.Min(Max, Below);
            string from = Min >= Above ? "at least" : "above", to = Max <= Below ? "at most" : "below";
            return (double.IsFinite(low), double.IsFinite(high)) switch
            {
                (false, false) => "a finite number",
                (true, false) => string.Create(CultureInfo.InvariantCulture, $"a number {from} {low}"),
                (false, true) => string.Create(CultureInfo.InvariantCulture, $"a number {to} {high}"),
                _ => string.Create(CultureInfo.InvariantCulture, $"a number {from} {low} and {to} {high}"),
            };
        }
    }

    public override bool TryRead(SceneNode node, SceneReading reading, out double value)
    {
        value = 0;
        if (node.Kind != NodeKind.Number)
        {
            return reading.WrongValue(node, Allowed);
        }

        if (!node.TryNumber(out value))
        {
            return reading.Mistake(node, $"{Wording.Name(node.NumberText())} is beyond the range of numbers", Allowed);
        }

        bool inside = value >= Min && value <= Max && value > Above && value < Below;
        return inside || reading.WrongValue(node, Allowed);
    }

    public override JsonObject Schema(SchemaBuilder schema)
    {
        JsonObject result = new() { ["type"] = "number" };
        (string Name, double Value)[] ends = [("minimum", Min), ("maximum", Max), ("exclusiveMinimum", Above), ("exclusiveMaximum", Below)];
        foreach ((string name, double value) in ends.Where(end => double.IsFinite(end.Value)))
        {
            result[name] = value;
        }

        return result;
    }

    public override JsonNode? Write(double value) => JsonValue.Create(value);
}
