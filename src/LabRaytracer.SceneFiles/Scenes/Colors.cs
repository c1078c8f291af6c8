using System.Diagnostics.CodeAnalysis;
using System.Globalization;
using System.Text.Json.Nodes;

namespace LabRaytracer;

/// <summary>Colours of scene files: 0.5 is grey, [r, g, b] is linear light, "#rrggbb" is sRGB.</summary>
internal static class Colors
{
    /// <summary>What a colour may look like, for messages.</summary>
    public const string Words = "a number (grey), [r, g, b] of at least 0, \"#rrggbb\"";

    /// <summary>A component; the largest leaves room for products of a few.</summary>
    public static NumberFormat Component { get; } = new() { Min = 0, Max = 1e9 };

    /// <summary>A linear grey.</summary>
    public static Format<Intensity> Grey { get; } = new MappedFormat<double, Intensity>(Component, grey => Intensity.Grey((float)grey));

    /// <summary>Linear components.</summary>
    public static Format<Intensity> Linear { get; } = new NumbersFormat<Intensity>(
        3, Words, n => new Intensity((float)n[0], (float)n[1], (float)n[2]), color => [color.R, color.G, color.B])
    { Item = Component };

    /// <summary>Any of the three.</summary>
    public static Format<Intensity> Any { get; } = new EitherFormat<Intensity>(
        Words, (NodeKind.Number, Grey), (NodeKind.Array, Linear), (NodeKind.Text, new HexFormat()))
    { Name = "color" };

    /// <summary>Reads "#rrggbb".</summary>
    public static bool TryHex(string text, out Intensity color)
    {
        color = default;
        if (text.Length != 7 || text[0] != '#' || !text.AsSpan(1).ToString().All(char.IsAsciiHexDigit))
        {
            return false;
        }

        int code = int.Parse(text.AsSpan(1), NumberStyles.AllowHexSpecifier, CultureInfo.InvariantCulture);
        color = new Intensity(
            ColorEncoding.LinearFromSrgb8((byte)(code >> 16)), ColorEncoding.LinearFromSrgb8((byte)(code >> 8)), ColorEncoding.LinearFromSrgb8((byte)code));
        return true;
    }

    private sealed class HexFormat : Format<Intensity>
    {
        public override string Allowed => Words;

        public override bool TryRead(SceneNode node, SceneReading reading, [MaybeNullWhen(false)] out Intensity value) =>
            TryHex(node.Text(), out value) || reading.WrongValue(node, Allowed);

        public override JsonObject Schema(SchemaBuilder schema) => new() { ["type"] = "string", ["pattern"] = "^#[0-9a-fA-F]{6}$" };
    }
}
