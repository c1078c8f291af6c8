namespace LabRaytracer;

/// <summary>Materials of scene files.</summary>
internal static class MaterialFormats
{
    private static readonly Material s_default = new();

    private static readonly Key<TextureSlot> s_ambient = Key.Optional("ambient", SlotFormats.Color, "k_a: share of ambient light that is reflected. Default: the same as diffuse.");

    private static readonly Key<TextureSlot> s_diffuse = Key.Optional("diffuse", SlotFormats.Color, s_default.Diffuse, "k_d: matte (Lambert) reflectance.");

    private static readonly Key<TextureSlot> s_specular = Key.Optional("specular", SlotFormats.Color, s_default.Specular, "k_s: reflectance of the highlight.");

    private static readonly Key<ScalarSlot> s_shininess = Key.Optional(
        "shininess", SlotFormats.Number("shininessSlot", new NumberFormat { Min = 0, Max = 1e6 }, s_default.Shininess.Value), s_default.Shininess, "Exponent of the highlight.");

    private static readonly Key<TextureSlot> s_reflection = Key.Optional("reflection", SlotFormats.Color, s_default.Reflection, "k_r: share of mirrored light.");

    private static readonly Key<TextureSlot> s_transparency = Key.Optional(
        "transparency", SlotFormats.Color, s_default.Transparency, "k_t: share of light that passes through.");

    private static readonly Key<ScalarSlot> s_indexOfRefraction = Key.Optional(
        "indexOfRefraction",
        SlotFormats.Number("indexOfRefractionSlot", new NumberFormat { Min = 0.01, Max = 100 }, s_default.IndexOfRefraction.Value),
        s_default.IndexOfRefraction,
        "Index of refraction inside relative to outside: glass 1.5, water 1.33.");

    private static readonly Key<FresnelModel> s_fresnel = Key.Optional(
        "fresnel", ChoiceFormat.Of<FresnelModel>(), FresnelModel.None, "How a transparent material shares light between reflection and refraction.");

    private static readonly Key<TextureSlot> s_emission = Key.Optional("emission", SlotFormats.Color, s_default.Emission, "Light that the surface gives off by itself.");

    private static readonly Key<ScalarSlot> s_opacity = Key.Optional(
        "opacity",
        SlotFormats.Number("opacitySlot", NumberFormat.Share, s_default.Opacity.Value),
        s_default.Opacity,
        "How much of the surface is there, 0 to 1: rays and light pass straight through the rest. For the alpha of a picture: { \"texture\": ..., \"channel\": \"alpha\" }.");

    private static readonly Key<ScalarSlot> s_occlusion = Key.Optional(
        "occlusion",
        SlotFormats.Number("occlusionSlot", NumberFormat.Share, s_default.Occlusion.Value),
        s_default.Occlusion,
        "Factor of the ambient light that arrives; amount s weakens a texture o to 1 + s (o - 1).");

    private static readonly Key<TextureSlot> s_lightMap = Key.Optional(
        "lightMap", SlotFormats.Color, s_default.LightMap, "Light that was computed beforehand, before it is multiplied by diffuse.");

    private static readonly Key<LightMapMode> s_lightMapMode = Key.Optional(
        "lightMapMode", ChoiceFormat.Of<LightMapMode>(), LightMapMode.Add, "Whether the light map adds to the lamps' light or replaces it.");

    private static readonly Key<ScalarSlot> s_bump = Key.Optional(
        "bump",
        SlotFormats.Number("bumpSlot", new NumberFormat { Min = -1e6, Max = 1e6 }, 1),
        "Heights that tilt the normal as if the surface were raised; value is the height, scene units, where the texture is 1. Default: smooth.");

    private static readonly Key<NormalMap> s_normalMap = Key.Optional("normalMap", SlotFormats.NormalMap, "Normals in tangent space. Default: the surface's own.");

    private static readonly Key<Material> s_inside = Key.Optional(
        "inside",
        new NameFormat<Material>("material", "materials", reading => reading.Materials),
        "Name of another material, for the side that normals point away from. Default: this one.");

    private static readonly ObjectFormat<Material> s_inline = new(
        "material",
        "How a surface looks: coefficients of the lighting model, each a value or a texture.",
        [s_ambient, s_diffuse, s_specular, s_shininess, s_reflection, s_transparency, s_indexOfRefraction, s_fresnel, s_emission, s_opacity, s_occlusion, s_lightMap, s_lightMapMode, s_bump, s_normalMap, s_inside],
        Build);

    /// <summary>Named materials.</summary>
    public static MapFormat<Material> Map { get; } = new(s_inline, reading => reading.Materials);

    /// <summary>A material by name or in place.</summary>
    public static EitherFormat<Material> Any { get; } = new(
        "the name of a material, or a material { \"diffuse\": ... }",
        (NodeKind.Text, new NameFormat<Material>("material", "materials", reading => reading.Materials)),
        (NodeKind.Object, s_inline))
    { Name = "materialReference" };

    private static Material Build(Fields fields) => new()
    {
        Name = fields.Reading.NameBeingRead,
        Ambient = fields.Find(s_ambient),
        Diffuse = fields.Get(s_diffuse),
        Specular = fields.Get(s_specular),
        Shininess = fields.Get(s_shininess),
        Reflection = fields.Get(s_reflection),
        Transparency = fields.Get(s_transparency),
        IndexOfRefraction = fields.Get(s_indexOfRefraction),
        Fresnel = fields.Get(s_fresnel),
        Emission = fields.Get(s_emission),
        Opacity = fields.Get(s_opacity),
        Occlusion = fields.Get(s_occlusion),
        LightMap = fields.Get(s_lightMap),
        LightMapMode = fields.Get(s_lightMapMode),
        Bump = fields.Find(s_bump),
        NormalMap = fields.Find(s_normalMap),
        Inside = fields.Find(s_inside),
    };
}
