namespace LabRaytracer;

/// <summary>The alpha of another texture as a grey: a weight for mixtures and layers.</summary>
/// <remarks>White for textures without alpha. Immutable, thread safe if the source is.</remarks>
public sealed class AlphaTexture : IPreparedTexture
{
    /// <summary>The alpha of a texture.</summary>
    /// <param name="source">The texture.</param>
    /// <exception cref="ArgumentNullException">The source is missing.</exception>
    public AlphaTexture(ITexture source) => Source = PropertyChecks.NotNull(source);

    /// <summary>The texture.</summary>
    public ITexture Source { get; }

    /// <inheritdoc/>
    public TextureNeeds Needs => Source.HasAlpha ? Source.Needs : TextureNeeds.None;

    /// <inheritdoc/>
    public Intensity Sample(in TextureLookup lookup) => Source.HasAlpha ? Intensity.Grey(Source.Alpha(lookup)) : Intensity.White;

    TextureSampler IPreparedTexture.Prepare(TextureUse use, TextureFilter? filter) =>
        Source.HasAlpha ? TextureParts.Prepare(Source, TextureUse.Alpha, filter) : new ConstantSampler(Intensity.White);
}
