namespace LabRaytracer;

/// <summary>What a picture shows outside [0, 1], chosen for u and v separately.</summary>
public enum TextureWrap
{
    /// <summary>The picture is repeated: u - floor(u).</summary>
    Repeat,

    /// <summary>The edge texel goes on.</summary>
    Clamp,

    /// <summary>The picture is repeated, every second one mirrored.</summary>
    Mirror,

    /// <summary>Black outside the picture.</summary>
    Border,
}
