namespace LabRaytracer;

/// <summary>Textures on top of each other: paint on rust on metal.</summary>
/// <remarks>From the bottom: color = lerp(color, layer, coverage), the "over" of images with straight alpha. Immutable, thread safe if the parts are.</remarks>
public sealed class LayeredTexture : IPreparedTexture
{
    private readonly ITexture _folded;

    /// <summary>A stack of textures.</summary>
    /// <param name="ground">The texture below all layers.</param>
    /// <param name="layers">The layers, from the lowest to the topmost.</param>
    /// <exception cref="ArgumentNullException">A texture is missing.</exception>
    public LayeredTexture(ITexture ground, params IEnumerable<TextureCover> layers)
    {
        Ground = PropertyChecks.NotNull(ground);
        Layers = [.. PropertyChecks.NotNull(layers)];
        _folded = Layers.Aggregate(ground, (below, layer) => new MixTexture(below, layer.Texture, layer.Coverage ?? new AlphaTexture(layer.Texture)));
    }

    /// <summary>The texture below all layers.</summary>
    public ITexture Ground { get; }

    /// <summary>The layers, from the lowest to the topmost.</summary>
    public IReadOnlyList<TextureCover> Layers { get; }

    /// <inheritdoc/>
    public TextureNeeds Needs => _folded.Needs;

    /// <inheritdoc/>
    public Intensity Sample(in TextureLookup lookup) => _folded.Sample(lookup);

    TextureSampler IPreparedTexture.Prepare(TextureUse use, TextureFilter? filter) => TextureParts.Prepare(_folded, use, filter);
}
