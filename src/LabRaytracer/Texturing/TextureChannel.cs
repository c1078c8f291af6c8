namespace LabRaytracer;

/// <summary>Which number of a texture's colour drives a scalar coefficient.</summary>
public enum TextureChannel
{
    /// <summary>Relative luminance (the default).</summary>
    Luminance,

    /// <summary>Red.</summary>
    Red,

    /// <summary>Green.</summary>
    Green,

    /// <summary>Blue.</summary>
    Blue,

    /// <summary>Alpha: 1 opaque, 0 not there; 1 everywhere in a texture without alpha.</summary>
    Alpha,
}
