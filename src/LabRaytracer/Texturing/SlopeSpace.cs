namespace LabRaytracer;

/// <summary>What the slopes of heights are derivatives by.</summary>
internal enum SlopeSpace
{
    /// <summary>Texture coordinates.</summary>
    Texture,

    /// <summary>The local point.</summary>
    Local,

    /// <summary>The point in world space.</summary>
    World,
}
