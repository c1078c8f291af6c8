namespace LabRaytracer;

/// <summary>Two textures mixed: lerp(first, second, w), with w the luminance of a third one, limited to [0, 1].</summary>
/// <remarks>
/// Where all points of a group have the weight 0 or 1, the other texture is not looked up; a weight that is 0 or 1 everywhere drops it when the texture is made ready.
/// A picture as weight is read as light; set its colour space to linear if its codes are the weights. Immutable, thread safe if the parts are.
/// </remarks>
public sealed class MixTexture : IPreparedTexture
{
    /// <summary>A mixture by a texture.</summary>
    /// <param name="first">Texture of the weight 0.</param>
    /// <param name="second">Texture of the weight 1.</param>
    /// <param name="weight">Texture whose luminance is the weight.</param>
    /// <exception cref="ArgumentNullException">A texture is missing.</exception>
    public MixTexture(ITexture first, ITexture second, ITexture weight)
    {
        First = PropertyChecks.NotNull(first);
        Second = PropertyChecks.NotNull(second);
        Weight = PropertyChecks.NotNull(weight);
    }

    /// <summary>An even mixture.</summary>
    /// <param name="first">Texture of the weight 0.</param>
    /// <param name="second">Texture of the weight 1.</param>
    /// <param name="weight">The weight everywhere, [0, 1]. Default: 0.5.</param>
    /// <exception cref="ArgumentNullException">A texture is missing.</exception>
    /// <exception cref="ArgumentOutOfRangeException">The weight is outside [0, 1] or NaN.</exception>
    public MixTexture(ITexture first, ITexture second, double weight = 0.5)
        : this(first, second, new ConstantTexture(Intensity.Grey((float)PropertyChecks.Share(weight, "weight of a mixture"))))
    {
    }

    /// <summary>Texture of the weight 0.</summary>
    public ITexture First { get; }

    /// <summary>Texture of the weight 1.</summary>
    public ITexture Second { get; }

    /// <summary>Texture whose luminance is the weight.</summary>
    public ITexture Weight { get; }

    /// <inheritdoc/>
    public TextureNeeds Needs => Only?.Needs ?? (First.Needs | Second.Needs | Weight.Needs);

    /// <summary>The one texture that is seen where the weight is 0 or 1 everywhere.</summary>
    private ITexture? Only => TextureParts.Constant(Weight)?.Luminance switch
    {
        <= 0 => First,
        >= 1 => Second,
        _ => null,
    };

    /// <inheritdoc/>
    public Intensity Sample(in TextureLookup lookup) => Only is { } only
        ? only.Sample(lookup)
        : BlendSampler.Blend(First, Second, Weight.Sample(lookup), null, lookup);

    TextureSampler IPreparedTexture.Prepare(TextureUse use, TextureFilter? filter) => Only is { } only
        ? TextureParts.Prepare(only, use, filter)
        : new BlendSampler(
            TextureParts.Prepare(First, use, filter), TextureParts.Prepare(Second, use, filter), TextureParts.Prepare(Weight, TextureUse.Color, filter), null);
}
