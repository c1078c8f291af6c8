namespace LabRaytracer;

/// <summary>What a texture must know of a hit: what it does not need is not computed.</summary>
[Flags]
public enum TextureNeeds
{
    /// <summary>Nothing: the colour is the same everywhere.</summary>
    None = 0,

    /// <summary>Texture coordinates (u, v): the mapping is evaluated.</summary>
    Coordinate = 1,

    /// <summary>The local point (x, y, z) and its normal: a 3D texture.</summary>
    LocalPoint = 2,

    /// <summary>
    /// What a sample covers: of texture space with <see cref="Coordinate"/>, of the surface with <see cref="LocalPoint"/> and <see cref="WorldPoint"/>. Rays then carry
    /// their differentials.
    /// </summary>
    Footprint = 4,

    /// <summary>The point in world space and its normal: a 3D texture that objects move through.</summary>
    WorldPoint = 8,
}
