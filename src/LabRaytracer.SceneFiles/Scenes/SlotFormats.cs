using System.Diagnostics.CodeAnalysis;
using System.Text.Json.Nodes;

namespace LabRaytracer;

/// <summary>Coefficients of materials: a value, a texture, or a value modulated by a texture.</summary>
internal static class SlotFormats
{
    private static readonly Key<TextureCoordinate> s_offset = Key.Optional(
        "offset", Coordinates.Uv, new TextureCoordinate(0, 0), "Added to (u, v), last.");

    private static readonly Key<TextureCoordinate> s_scale = Key.Optional(
        "scale",
        new EitherFormat<TextureCoordinate>(
            "a number, or two numbers [u, v]",
            (NodeKind.Array, Coordinates.Uv),
            (NodeKind.Number, new MappedFormat<double, TextureCoordinate>(NumberFormat.Any, factor => new TextureCoordinate(factor, factor)))),
        new TextureCoordinate(1, 1),
        "Factors of u and v, applied first: 2 shows a picture twice.");

    private static readonly Key<double> s_rotate = Key.Optional("rotateDegrees", NumberFormat.Any, 0, "Turn of (u, v), degrees, counter-clockwise with v up.");

    private static readonly Key<TextureCoordinate> s_center = Key.Optional(
        "center", Coordinates.Uv, new TextureCoordinate(0, 0), "The point that scale and rotation leave in place.");

    private static readonly ObjectFormat<UvTransform> s_uvTransform = new(
        "uvTransform",
        "Transform of texture coordinates: scale, then rotation, then offset.",
        [s_offset, s_scale, s_rotate, s_center],
        fields => fields.Make(
            s_scale,
            () => new UvTransform(fields.Get(s_offset), fields.Get(s_rotate), fields.Get(s_scale), fields.Get(s_center)),
            "the numbers of the transform are so large that their product is no number",
            "smaller numbers"));

    /// <summary>A transform of texture coordinates.</summary>
    public static ObjectFormat<UvTransform> UvTransforms => s_uvTransform;

    private static readonly Key<Intensity> s_value = Key.Optional("value", Colors.Any, Intensity.White, "The coefficient without texture, linear.");

    private static readonly Key<double> s_number = Key.Optional("value", NumberFormat.Any, "The coefficient without texture. Default: that of the key.");

    private static readonly Key<ITexture> s_texture = Key.Optional("texture", TextureFormats.Any, "Name of a texture, or a texture in place. Default: none.");

    private static readonly Key<double> s_amount = Key.Optional("amount", NumberFormat.Share, 1, "How much of the texture's effect is applied.");

    private static readonly Key<BlendMode> s_blend = Key.Optional(
        "blend", ChoiceFormat.Of<BlendMode>(), BlendMode.Multiply, "How the texture changes the value k: k T, T, k + T, or the mean of k and T.");

    private static readonly Key<IMapping> s_mapping = Key.Optional(
        "mapping",
        MappingFormats.Any,
        "How the surface is mapped to (u, v). Default: as the shape suggests.");

    private static readonly Key<UvTransform> s_transform = Key.Optional("transform", s_uvTransform, "Transform of (u, v) before the lookup. Default: none.");

    private static readonly Key<TextureChannel> s_channel = Key.Optional(
        "channel", ChoiceFormat.Of<TextureChannel>(), TextureChannel.Luminance, "Which number of the texture's colour is read.");

    private static readonly Key<ITexture> s_layerTexture = Key.Required("texture", TextureFormats.Any, "Name of a texture, or a texture in place.");

    private static readonly Key<double> s_layerOpacity = Key.Optional("opacity", NumberFormat.Share, 1, "Factor of the texture's alpha.");

    private static readonly Key<BlendMode> s_layerBlend = Key.Optional(
        "blend", ChoiceFormat.Of<BlendMode>(), BlendMode.Replace, "What becomes of the value k below where the layer is opaque: k T, T, k + T, or the mean of k and T.");

    private static readonly Key<TextureCoordinate> s_placeCenter = Key.Required("center", Coordinates.Uv, "Centre of the picture in (u, v).");

    private static readonly Key<TextureCoordinate> s_placeSize = Key.Required("size", Coordinates.Uv, "Width and height of the picture in u and v, above 0.");

    private static readonly Key<double> s_placeRotate = Key.Optional("rotateDegrees", NumberFormat.Any, 0, "Turn of the picture, degrees, counter-clockwise with v up.");

    private static readonly Key<UvTransform> s_place = Key.Optional(
        "place",
        new ObjectFormat<UvTransform>(
            "place",
            "Where a picture is stuck onto a surface, once.",
            [s_placeCenter, s_placeSize, s_placeRotate],
            fields => fields.Make(
                s_placeSize,
                () => UvTransform.Placing(fields.Get(s_placeCenter), fields.Get(s_placeSize), fields.Get(s_placeRotate)),
                "no picture is that small",
                "a width and a height above 0")),
        "Makes the layer a decal: the texture is there once, at this place. Takes the place of transform.");

    private static readonly ObjectFormat<TextureLayer> s_layer = new(
        "layer", "A texture over what is below it.", [s_layerTexture, s_layerOpacity, s_layerBlend, s_mapping, s_transform, s_place], Layer);

    private static readonly Key<IReadOnlyList<TextureLayer>> s_layers = Key.Optional(
        "layers", new ListFormat<TextureLayer>(s_layer, "layers"), "Textures over the result, from the bottom up. Default: none.");

    private static readonly ObjectFormat<TextureSlot> s_colorSlot = new(
        "colorSlot", "A colour modulated by a texture.", [s_value, s_texture, s_amount, s_blend, s_mapping, s_transform, s_layers], ColorSlot);

    /// <summary>A colour coefficient.</summary>
    public static EitherFormat<TextureSlot> Color { get; } = new(
        $"{Colors.Words}, the name of a texture, an object {{ value, texture, ... }}",
        (NodeKind.Array, new MappedFormat<Intensity, TextureSlot>(Colors.Linear, color => color, slot => slot.Value)),
        (NodeKind.Number, new MappedFormat<Intensity, TextureSlot>(Colors.Grey, grey => grey)),
        (NodeKind.Text, new TextSlotFormat()),
        (NodeKind.Object, s_colorSlot))
    { Name = "coefficient" };

    private static readonly Key<double> s_strength = Key.Optional("strength", new NumberFormat { Min = 0, Max = 1000 }, 1, "Factor of the normals' x and y: 0 is flat.");

    private static readonly Key<bool> s_flipGreen = Key.Optional("flipGreen", SwitchFormat.Instance, false, "Whether green points down (DirectX) instead of up (OpenGL, glTF).");

    private static readonly Key<bool> s_rebuildZ = Key.Optional("rebuildZ", SwitchFormat.Instance, false, "Whether z is computed from x and y instead of read from blue.");

    private static readonly ObjectFormat<NormalMap> s_normalMap = new(
        "normalMap",
        "Normals in tangent space: red to the right, green up, blue out of the surface.",
        [s_layerTexture, s_strength, s_flipGreen, s_rebuildZ, s_mapping, s_transform],
        fields => new NormalMap(fields.Get(s_layerTexture))
        {
            Strength = (float)fields.Get(s_strength),
            FlipGreen = fields.Get(s_flipGreen),
            RebuildZ = fields.Get(s_rebuildZ),
            Mapping = fields.Find(s_mapping),
            Transform = fields.Find(s_transform) ?? UvTransform.Identity,
        });

    /// <summary>A normal map.</summary>
    public static EitherFormat<NormalMap> NormalMap { get; } = new(
        "the name of a texture, an object { texture, strength, flipGreen, ... }",
        (NodeKind.Text, new MappedFormat<ITexture, NormalMap>(TextureFormats.Name, texture => new NormalMap(texture))),
        (NodeKind.Object, s_normalMap));

    /// <summary>A number coefficient.</summary>
    /// <param name="name">Name in the schema.</param>
    /// <param name="range">What the number may be.</param>
    /// <param name="standard">The value where a slot gives a texture alone.</param>
    public static EitherFormat<ScalarSlot> Number(string name, NumberFormat range, double standard)
    {
        Key<double> value = Key.Optional("value", range, standard, s_number.Description);
        ObjectFormat<ScalarSlot> slot = new(
            name,
            "A number modulated by a texture.",
            [value, s_texture, s_channel, s_amount, s_blend, s_mapping, s_transform],
            fields => NumberSlot(fields, fields.Get(value)));
        return new EitherFormat<ScalarSlot>(
            $"{range.Allowed}, the name of a texture, an object {{ value, texture, ... }}",
            (NodeKind.Number, new MappedFormat<double, ScalarSlot>(range, number => number, back => back.Value)),
            (NodeKind.Text, new MappedFormat<ITexture, ScalarSlot>(
                TextureFormats.Name, texture => new ScalarSlot { Value = (float)standard, Texture = texture })),
            (NodeKind.Object, slot));
    }

    private static TextureSlot ColorSlot(Fields fields) => new()
    {
        Value = fields.Get(s_value),
        Texture = fields.Find(s_texture),
        Amount = (float)fields.Get(s_amount),
        Blend = fields.Get(s_blend),
        Mapping = fields.Find(s_mapping),
        Transform = fields.Find(s_transform) ?? UvTransform.Identity,
        Layers = fields.Find(s_layers) ?? [],
    };

    private static TextureLayer? Layer(Fields fields)
    {
        if (fields.Has(s_place) && fields.Has(s_transform))
        {
            fields.Fail(s_transform, "a layer has one transform", "place or transform");
            return null;
        }

        return new TextureLayer(fields.Get(s_layerTexture))
        {
            Opacity = (float)fields.Get(s_layerOpacity),
            Blend = fields.Get(s_layerBlend),
            Mapping = fields.Find(s_mapping),
            Transform = fields.Find(s_place) ?? fields.Find(s_transform) ?? UvTransform.Identity,
            IsDecal = fields.Has(s_place),
        };
    }

    private static ScalarSlot NumberSlot(Fields fields, double value) => new()
    {
        Value = (float)value,
        Texture = fields.Find(s_texture),
        Channel = fields.Get(s_channel),
        Amount = (float)fields.Get(s_amount),
        Blend = fields.Get(s_blend),
        Mapping = fields.Find(s_mapping),
        Transform = fields.Find(s_transform) ?? UvTransform.Identity,
    };

    /// <summary>A text in the place of a coefficient: a colour if it starts with '#', else the name of a texture.</summary>
    private sealed class TextSlotFormat : Format<TextureSlot>
    {
        public override string Allowed => Color.Allowed;

        public override bool TryRead(SceneNode node, SceneReading reading, [MaybeNullWhen(false)] out TextureSlot value)
        {
            if (node.Text().StartsWith('#'))
            {
                bool good = Colors.Any.TryRead(node, reading, out Intensity color);
                value = color;
                return good;
            }

            bool known = TextureFormats.Name.TryRead(node, reading, out ITexture? texture);
            value = known ? TextureSlot.Of(texture!) : null;
            return known;
        }

        public override JsonObject Schema(SchemaBuilder schema) => new() { ["type"] = "string", ["minLength"] = 1 };
    }
}
