namespace LabRaytracer;

/// <summary>How a colour is made of the texels around a point.</summary>
public enum TextureFilter
{
    /// <summary>The nearest texel alone: hard edges.</summary>
    Nearest,

    /// <summary>Four texels, weighted by nearness.</summary>
    Bilinear,
}
