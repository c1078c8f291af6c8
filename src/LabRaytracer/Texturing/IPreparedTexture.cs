namespace LabRaytracer;

/// <summary>A texture that can be made ready for a render.</summary>
internal interface IPreparedTexture : ITexture
{
    /// <summary>Makes the texture ready: decodes its file, packs its texels.</summary>
    /// <param name="isData">True in slots of numbers, where codes are not sRGB-decoded by default.</param>
    /// <param name="filter">Filter that overrides the texture's own, or null.</param>
    TextureSampler Prepare(bool isData, TextureFilter? filter);
}
