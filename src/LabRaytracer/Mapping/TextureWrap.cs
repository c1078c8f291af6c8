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

    /// <summary>Nothing outside the picture: the border colour (<see cref="SamplingOptions.BorderColor"/>, black by default), with alpha 0, so that in layers what is below shows.</summary>
    Border,

    /// <summary>
    /// The edge texel goes on, and where a filter reads beyond the edge, it goes on at the other side of the pole: (u + 1/2, -v) below v = 0, (u + 1/2, 2 - v) above v = 1.
    /// For the v of spherical maps; the filters nearest, bilinear, Catmull-Rom and B-spline do not look beyond the edge.
    /// </summary>
    Pole,
}
