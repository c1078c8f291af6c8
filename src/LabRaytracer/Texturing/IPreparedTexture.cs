namespace LabRaytracer;

/// <summary>A texture that can be made ready for a render.</summary>
internal interface IPreparedTexture : ITexture
{
    /// <summary>What the texture must know of a hit under a filter that overrides its own, or null. Default: the same as without.</summary>
    TextureNeeds NeedsUnder(TextureFilter? filter) => Needs;

    /// <summary>Makes the texture ready: decodes its file, packs its texels.</summary>
    /// <param name="use">What is read of it; alpha only of a texture that has one.</param>
    /// <param name="filter">Filter that overrides the texture's own, or null.</param>
    TextureSampler Prepare(TextureUse use, TextureFilter? filter);

    /// <summary>Makes the slopes of the texture's heights ready. Default: differences of lookups.</summary>
    /// <param name="channel">Which channel is the height.</param>
    /// <param name="wrapU">Wrap in u that the mapping suggests.</param>
    /// <param name="wrapV">Wrap in v that the mapping suggests.</param>
    /// <param name="filter">Filter that overrides the texture's own, or null.</param>
    TextureSampler PrepareSlopes(TextureChannel channel, TextureWrap wrapU, TextureWrap wrapV, TextureFilter? filter) => new SlopeSampler(
        Prepare(channel == TextureChannel.Alpha ? TextureUse.Alpha : TextureUse.Data, filter), channel, SlopeSampler.SpaceOf(this));
}
