namespace LabRaytracer;

/// <summary>A layer over other textures.</summary>
/// <param name="Texture">Its colours.</param>
/// <param name="Coverage">A texture whose luminance says how much of what is below the layer covers: 0 nothing, 1 all of it. Null (default): the alpha of the texture.</param>
/// <remarks>Immutable, thread safe if the parts are.</remarks>
public readonly record struct TextureCover(ITexture Texture, ITexture? Coverage = null);
