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
}
