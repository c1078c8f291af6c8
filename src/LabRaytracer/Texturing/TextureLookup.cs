namespace LabRaytracer;

/// <summary>Where a texture is asked for its colour.</summary>
/// <param name="Coordinate">Texture coordinates after the slot's uv transform, v up; not yet wrapped. Meaningful if the texture needs them.</param>
/// <param name="LocalPoint">The hit in the shape's unit form, object space. Meaningful if the texture needs it.</param>
/// <param name="LocalNormal">Outward normal there, length 1. Meaningful if the texture needs the local point.</param>
/// <param name="WrapU">Wrap in u that the mapping suggests.</param>
/// <param name="WrapV">Wrap in v that the mapping suggests.</param>
/// <param name="Footprint">What the sample covers of texture space, after the slot's uv transform. Meaningful if the texture needs footprint and coordinates.</param>
/// <param name="LocalFootprint">What the sample covers of the surface, object space. Meaningful if the texture needs footprint and local point.</param>
/// <remarks>Immutable, thread safe.</remarks>
public readonly record struct TextureLookup(
    TextureCoordinate Coordinate,
    Point3D LocalPoint = default,
    Vector3D LocalNormal = default,
    TextureWrap WrapU = TextureWrap.Repeat,
    TextureWrap WrapV = TextureWrap.Repeat,
    TextureFootprint Footprint = default,
    SurfaceFootprint LocalFootprint = default)
{
    /// <summary>The hit in world space. Meaningful if the texture needs it.</summary>
    public Point3D WorldPoint { get; init; }

    /// <summary>Outward geometric normal there, world space, length 1. Meaningful if the texture needs the world point.</summary>
    public Vector3D WorldNormal { get; init; }

    /// <summary>What the sample covers of the surface, world space. Meaningful if the texture needs footprint and world point.</summary>
    public SurfaceFootprint WorldFootprint { get; init; }

    /// <summary>A lookup by (u, v) alone.</summary>
    /// <param name="u">Horizontal coordinate.</param>
    /// <param name="v">Vertical coordinate, up.</param>
    public static TextureLookup At(double u, double v) => new(new TextureCoordinate(u, v));

    /// <summary>A lookup by local point and normal alone, for 3D textures.</summary>
    /// <param name="point">Local point.</param>
    /// <param name="normal">Outward local normal, length 1.</param>
    public static TextureLookup At(Point3D point, Vector3D normal = default) => new(default, point, normal);
}
