namespace LabRaytracer;

/// <summary>How a colour is made of the texels around a point.</summary>
public enum TextureFilter
{
    /// <summary>The nearest texel alone: hard edges.</summary>
    Nearest,

    /// <summary>Four texels, weighted by nearness.</summary>
    Bilinear,

    /// <summary>
    /// Sixteen texels by the cubic of Catmull and Rom: sharp, goes through the texels. In colour slots a result that leaves the range of its sixteen texels
    /// is set to the end of that range (nothing gets darker than black); in slots of numbers the overshoot is kept.
    /// </summary>
    CatmullRom,

    /// <summary>Sixteen texels by the uniform cubic B-spline: soft, twice differentiable, never leaves the range of its texels.</summary>
    BSpline,
}
