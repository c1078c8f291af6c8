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

    /// <summary>
    /// Over the footprint of the sample, as wide in all directions as in its longest one: two bilinear colours of smaller versions of the picture, mixed.
    /// No flicker, but too soft where a surface is seen at a slant.
    /// </summary>
    Trilinear,

    /// <summary>
    /// Over the footprint of the sample, by its own width in every direction: a weighted mean of texels (what is called EWA: Greene and Heckbert 1986), each by its share in the
    /// parallelogram of the pixel, of the smaller version whose texels fit the shorter side. Up to 64 times as long as wide; longer footprints are filtered too softly, which the statistics count.
    /// </summary>
    Ewa,

    /// <summary>The exact mean of the bilinear picture over the footprint of the sample, within 1e-6: the reference that the other filters are measured by. Slow.</summary>
    Area,
}
