namespace LabRaytracer;

/// <summary>Which space a computed pattern fills.</summary>
public enum PatternSpace
{
    /// <summary>The object: the local point (x, y, z), as if carved out of a block. Needs no mapping, has no seams.</summary>
    Local,

    /// <summary>Texture space: (u, v), with the third coordinate 0.</summary>
    Uv,
}
