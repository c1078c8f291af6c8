namespace LabRaytracer;

/// <summary>The stages of a tile that are timed.</summary>
internal enum RenderStage
{
    /// <summary>Camera rays.</summary>
    Camera,

    /// <summary>Nearest hits.</summary>
    Intersect,

    /// <summary>Hits sorted by shape and material.</summary>
    Group,

    /// <summary>Points and normals.</summary>
    Surface,

    /// <summary>Mappings.</summary>
    Map,

    /// <summary>Texture lookups.</summary>
    Texture,

    /// <summary>Lamps and shadows.</summary>
    Light,

    /// <summary>Reflected and refracted rays, colours into pixels.</summary>
    Combine,
}
