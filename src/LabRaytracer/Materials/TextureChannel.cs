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
}
