namespace LabRaytracer;

/// <summary>One of two textures, chosen at every point by the luminance of a third one.</summary>
/// <remarks>Only what some point of a group shows is looked up; a constant selector drops the other texture. Immutable, thread safe if the parts are.</remarks>
public sealed class SelectTexture : IPreparedTexture
{
    /// <summary>A choice between two textures.</summary>
    /// <param name="selector">Texture whose luminance decides.</param>
    /// <param name="below">Texture where the luminance is below the threshold.</param>
    /// <param name="above">Texture where it is the threshold or more.</param>
    /// <param name="threshold">The threshold; finite. Default: 0.5.</param>
    /// <exception cref="ArgumentNullException">A texture is missing.</exception>
    /// <exception cref="ArgumentOutOfRangeException">The threshold is not finite.</exception>
    public SelectTexture(ITexture selector, ITexture below, ITexture above, double threshold = 0.5)
    {
        Selector = PropertyChecks.NotNull(selector);
        Below = PropertyChecks.NotNull(below);
        Above = PropertyChecks.NotNull(above);
        Threshold = (float)PropertyChecks.Finite(threshold, "threshold of a selection");
    }

    /// <summary>Texture whose luminance decides.</summary>
    public ITexture Selector { get; }

    /// <summary>Texture where the luminance is below the threshold.</summary>
    public ITexture Below { get; }

    /// <summary>Texture where the luminance is the threshold or more.</summary>
    public ITexture Above { get; }

    /// <summary>The threshold.</summary>
    public float Threshold { get; }

    /// <inheritdoc/>
    public TextureNeeds Needs => Only?.Needs ?? (Selector.Needs | Below.Needs | Above.Needs);

    private ITexture? Only => TextureParts.Constant(Selector) is { } color ? color.Luminance >= Threshold ? Above : Below : null;

    /// <inheritdoc/>
    public Intensity Sample(in TextureLookup lookup) => Only is { } only
        ? only.Sample(lookup)
        : BlendSampler.Blend(Below, Above, Selector.Sample(lookup), Threshold, lookup);

    TextureSampler IPreparedTexture.Prepare(TextureUse use, TextureFilter? filter) => Only is { } only
        ? TextureParts.Prepare(only, use, filter)
        : new BlendSampler(
            TextureParts.Prepare(Below, use, filter), TextureParts.Prepare(Above, use, filter), TextureParts.Prepare(Selector, TextureUse.Color, filter), Threshold);
}
