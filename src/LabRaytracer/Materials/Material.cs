namespace LabRaytracer;

/// <summary>How a surface looks (Polish: materiał): coefficients of the lighting model, each a value or a textured value.</summary>
/// <remarks>
/// Lab sheet IV, section 1.1 and task 2: the reference to a texture is inside the material. Immutable once built; thread safe. Only <see cref="Ambient"/> may be null; the others throw <see cref="ArgumentNullException"/>.
/// Light that leaves a point is emission + ambient * ambient light + sum over lights (shader's reflection of diffuse and specular)
/// + reflection * mirrored light + transparency * refracted light.
/// </remarks>
public sealed class Material
{
    /// <summary>Name for messages and statistics; may be empty.</summary>
    public string Name { get; init; } = "";

    /// <summary>k_a: share of ambient light that is reflected. Default: null, the same as <see cref="Diffuse"/>.</summary>
    public TextureSlot? Ambient { get; init; }

    /// <summary>k_d: Lambert reflectance. Default: white.</summary>
    public TextureSlot Diffuse { get; init => field = PropertyChecks.NotNull(value); } = Intensity.White;

    /// <summary>k_s: specular (highlight) reflectance. Default: black, no highlight.</summary>
    public TextureSlot Specular { get; init => field = PropertyChecks.NotNull(value); } = Intensity.Black;

    /// <summary>Specular exponent of the highlight, at least 0. Default: 50.</summary>
    public ScalarSlot Shininess { get; init => field = PropertyChecks.NotNull(value); } = 50;

    /// <summary>k_r: share of mirrored light. Default: black, no mirror.</summary>
    public TextureSlot Reflection { get; init => field = PropertyChecks.NotNull(value); } = Intensity.Black;

    /// <summary>k_t: share of light that passes through. Default: black, opaque.</summary>
    public TextureSlot Transparency { get; init => field = PropertyChecks.NotNull(value); } = Intensity.Black;

    /// <summary>Index of refraction inside the shape relative to outside, above 0. Default: 1 (nothing is bent).</summary>
    public ScalarSlot IndexOfRefraction { get; init => field = PropertyChecks.NotNull(value); } = 1;

    /// <summary>Share between reflection and refraction of a transparent material. Default: fixed.</summary>
    public FresnelModel Fresnel { get; init => field = PropertyChecks.Known(value); }

    /// <summary>Light that the surface gives off by itself. Default: black.</summary>
    public TextureSlot Emission { get; init => field = PropertyChecks.NotNull(value); } = Intensity.Black;

    /// <summary>Tells whether only the side that the normal points to gives off light.</summary>
    internal bool EmitsFromFrontOnly { get; init; }

    /// <summary>
    /// How much of the surface is there: 1 (default) all of it, 0 nothing, as if the object were not there; in between, that share of its light and the rest of
    /// what lies behind. Values outside [0, 1] count as the nearest end.
    /// </summary>
    /// <remarks>
    /// <para>Rays go straight on, unlike those of <see cref="Transparency"/>. A lamp's light is multiplied by 1 - opacity for every such surface on its way.</para>
    /// <para>A ray passes at most 256 surfaces with an opacity below 1; behind them is black.
    /// A colour slot that shows the picture whose alpha is read here gets colours weighted by alpha: hidden texels do not tint the edges.</para>
    /// </remarks>
    public ScalarSlot Opacity { get; init => field = PropertyChecks.NotNull(value); } = 1;

    /// <summary>Factor of the ambient light that arrives: an ambient occlusion map, which <see cref="ScalarSlot.Amount"/> s weakens to 1 + s (o - 1). Default: 1.</summary>
    public ScalarSlot Occlusion { get; init => field = PropertyChecks.NotNull(value); } = 1;

    /// <summary>Light that was computed beforehand and arrives here, before it is multiplied by <see cref="Diffuse"/>: a light map. Default: black, none.</summary>
    public TextureSlot LightMap { get; init => field = PropertyChecks.NotNull(value); } = Intensity.Black;

    /// <summary>Whether the light map adds to the lamps' light (default) or replaces it.</summary>
    public LightMapMode LightMapMode { get; init => field = PropertyChecks.Known(value); }

    /// <summary>
    /// Heights of the surface, scene units: the normal tilts as if the surface were raised by them along its normal (Blinn 1978). With the default blend,
    /// <see cref="ScalarSlot.Value"/> is the height where the texture is 1. Null (default): smooth.
    /// </summary>
    /// <remarks>
    /// The surface itself stays where it is: outlines and shadows are those of the smooth shape. The tilt does not depend on how the texture is stretched over the
    /// surface, only on the relief that results.
    /// </remarks>
    public ScalarSlot? Bump { get; init; }

    /// <summary>Normals of the surface in tangent space. Null (default): its own. A <see cref="Bump"/> comes on top of it.</summary>
    public NormalMap? NormalMap { get; init; }

    /// <summary>
    /// Material of the other side, which normals point away from: the inside of a vase, the back of a page. Null (default): the same.
    /// </summary>
    /// <remarks>Its own opacity and inside do not count: whether something is there is a matter of the surface, not of its sides.</remarks>
    public Material? Inside { get; init; }

    /// <summary>The lighting model. Default: Phong.</summary>
    public IShader Shader { get; init => field = PropertyChecks.NotNull(value); } = PhongShader.Default;

    /// <summary>A material whose only property is a texture: matte, lit by all lights.</summary>
    public static Material Matte(ITexture texture) => new() { Diffuse = TextureSlot.Of(texture) };
}
