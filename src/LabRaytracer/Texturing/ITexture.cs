namespace LabRaytracer;

/// <summary>A texture (Polish: tekstura): a colour for every point of a surface.</summary>
/// <remarks>
/// Lab sheet IV, section 1.1: a 2D texture returns the colour of its picture, a procedural one computes it, the simplest is constant.
/// Write your own by implementing <see cref="Sample"/>; the renderer calls it from several threads at once, so it must not change while rendering.
/// </remarks>
public interface ITexture
{
    /// <summary>What <see cref="Sample"/> reads of a lookup. Default: the texture coordinates.</summary>
    TextureNeeds Needs => TextureNeeds.Coordinate;

    /// <summary>The colour at a point.</summary>
    /// <param name="lookup">Where.</param>
    /// <returns>Linear colour, not clamped.</returns>
    Intensity Sample(in TextureLookup lookup);

    /// <summary>Tells whether <see cref="Alpha"/> can be below 1. Default: no, and it is never asked.</summary>
    bool HasAlpha => false;

    /// <summary>How much of the texture is there: 1 opaque, 0 nothing. Default: 1.</summary>
    /// <param name="lookup">Where.</param>
    /// <returns>Alpha, [0, 1].</returns>
    float Alpha(in TextureLookup lookup) => 1;
}
