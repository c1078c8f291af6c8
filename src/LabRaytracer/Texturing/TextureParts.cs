namespace LabRaytracer;

/// <summary>What textures made of other textures have in common.</summary>
internal static class TextureParts
{
    /// <summary>Groups of lanes that a combined texture looks up at a time: its parts' colours then stay in the first cache.</summary>
    public const int Chunk = 8;

    /// <summary>A part made ready: a constant if it needs nothing of a hit.</summary>
    public static TextureSampler Prepare(ITexture texture, TextureUse use, TextureFilter? filter) => texture switch
    {
        { Needs: TextureNeeds.None, HasAlpha: false } => new ConstantSampler(texture.Sample(default)),
        IPreparedTexture prepared => prepared.Prepare(use, filter),
        _ => new CustomSampler(texture, use),
    };

    /// <summary>The colour of a part that is the same everywhere; null if it is not.</summary>
    public static Intensity? Constant(ITexture texture) => texture is { Needs: TextureNeeds.None, HasAlpha: false } ? texture.Sample(default) : null;

    /// <summary>Columns for the colours of one part of a chunk.</summary>
    /// <param name="memory">Room for <c>3 * Chunk</c> groups of lanes.</param>
    public static unsafe ColorColumns<F> Columns<F>(F* memory)
        where F : unmanaged, IReal<F> => new() { R = memory, G = memory + Chunk, B = memory + (2 * Chunk) };
}
