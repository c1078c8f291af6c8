namespace LabRaytracer;

/// <summary>Textures of scene files that are made of other textures.</summary>
internal static class CombinationFormats
{
    private static readonly Key<ITexture> s_first = Key.Required("first", ProceduralFormats.Texture, "The first texture.");

    private static readonly Key<ITexture> s_second = Key.Required("second", ProceduralFormats.Texture, "The second texture.");

    private static readonly Key<ITexture> s_weight = Key.Optional(
        "weight",
        new EitherFormat<ITexture>(
            "a number at least 0 and at most 1, or a texture",
            (NodeKind.Number, new MappedFormat<double, ITexture>(NumberFormat.Share, share => new ConstantTexture(Intensity.Grey((float)share)))),
            (NodeKind.Text, ProceduralFormats.Texture),
            (NodeKind.Object, ProceduralFormats.Texture)),
        "Share of the second texture: a number, or a texture whose luminance it is. Default: 0.5.");

    private static readonly Key<ITexture> s_selector = Key.Required("selector", ProceduralFormats.Texture, "The texture whose luminance decides.");

    private static readonly Key<ITexture> s_below = Key.Required("below", ProceduralFormats.Texture, "Texture where the luminance is below the threshold.");

    private static readonly Key<ITexture> s_above = Key.Required("above", ProceduralFormats.Texture, "Texture where it is the threshold or more.");

    private static readonly Key<double> s_threshold = Key.Optional("threshold", NumberFormat.Any, 0.5, "The threshold.");

    private static readonly Key<ITexture> s_ground = Key.Required("ground", ProceduralFormats.Texture, "The texture below all layers.");

    private static readonly Key<ITexture> s_texture = Key.Required("texture", ProceduralFormats.Texture, "The texture.");

    private static readonly Key<ITexture> s_coverage = Key.Optional(
        "coverage", ProceduralFormats.Texture, "Texture whose luminance says how much of what is below is covered. Default: the alpha of the texture.");

    private static readonly ObjectFormat<LayerValue> s_layer = new(
        "textureCover", "A layer over other textures.", [s_texture, s_coverage], fields => new LayerValue(new TextureCover(fields.Get(s_texture), fields.Find(s_coverage))));

    private static readonly Key<IReadOnlyList<LayerValue>> s_layers = Key.Required(
        "layers", new ListFormat<LayerValue>(s_layer, "layers { texture, coverage }"), "The layers, from the lowest to the topmost.");

    private static readonly Key<IReadOnlyList<RampFormats.StopValue>> s_ramp = RampFormats.KeyOf("Colours of the luminance. Default: black at 0 to white at 1.");

    private static readonly Key<Transform> s_transform = Key.Optional("transform", TransformFormats.Any, "From the texture's space to the object's, or the world's. Default: none.");

    private static readonly Key<TextureFrame> s_frame = Key.Optional(
        "frame", ChoiceFormat.Of<TextureFrame>(), TextureFrame.Object, "What the texture is fixed to: the object, or the world that objects move through.");

    private static readonly Key<UvTransform> s_uv = Key.Optional("uv", SlotFormats.UvTransforms, "Transform of (u, v), after that of the slot. Default: none.");

    private static readonly Key<int> s_sharpness = Key.Optional("sharpness", new IntegerFormat(1, 64), 4, "How sharply one projection gives way to the next.");

    private static readonly Key<double> s_scale = Key.Optional("scale", NumberFormat.Positive, 1, "How often the texture is repeated over the cube [-1, 1]³.");

    /// <summary>The formats.</summary>
    public static IReadOnlyList<ObjectFormat<ITexture>> All { get; } =
    [
        new("multiplyTexture", "Two textures multiplied.", [s_first, s_second], fields => new ProductTexture(fields.Get(s_first), fields.Get(s_second)), ("type", "multiply")),
        new("mixTexture", "Two textures mixed.", [s_first, s_second, s_weight], Mix, ("type", "mix")),
        new(
            "selectTexture",
            "One of two textures, chosen by a third.",
            [s_selector, s_below, s_above, s_threshold],
            fields => new SelectTexture(fields.Get(s_selector), fields.Get(s_below), fields.Get(s_above), fields.Get(s_threshold)),
            ("type", "select")),
        new(
            "layersTexture",
            "Textures on top of each other.",
            [s_ground, s_layers],
            fields => new LayeredTexture(fields.Get(s_ground), fields.Get(s_layers).Select(layer => layer.Layer)),
            ("type", "layers")),
        new("rampTexture", "Colours for the luminance of a texture.", [s_texture, s_ramp], Ramp, ("type", "ramp")),
        new("transformedTexture", "A texture moved, turned, scaled.", [s_texture, s_transform, s_frame, s_uv], Transformed, ("type", "transformed")),
        new(
            "triplanarTexture",
            "A texture projected along three axes, blended by the normal.",
            [s_texture, s_sharpness, s_scale],
            fields => new TriplanarTexture(fields.Get(s_texture)) { Sharpness = fields.Get(s_sharpness), Scale = fields.Get(s_scale) },
            ("type", "triplanar")),
    ];

    private static MixTexture Mix(Fields fields) => fields.Find(s_weight) is { } weight
        ? new MixTexture(fields.Get(s_first), fields.Get(s_second), weight)
        : new MixTexture(fields.Get(s_first), fields.Get(s_second));

    private static RampTexture? Ramp(Fields fields) =>
        RampFormats.Get(fields, s_ramp, ColorRamp.Grey) is not { } ramp ? null : new RampTexture(fields.Get(s_texture), ramp);

    private static TransformedTexture Transformed(Fields fields) => new(fields.Get(s_texture), fields.Find(s_transform))
    {
        Frame = fields.Get(s_frame), Uv = fields.Find(s_uv) ?? UvTransform.Identity,
    };

    /// <summary>A layer as a reference, which a list of values may hold.</summary>
    /// <param name="Layer">The layer.</param>
    private sealed record LayerValue(TextureCover Layer);
}
