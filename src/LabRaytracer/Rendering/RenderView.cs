namespace LabRaytracer;

/// <summary>What a picture shows of the scene.</summary>
public enum RenderView
{
    /// <summary>Colour: the picture proper.</summary>
    Color,

    /// <summary>Texture coordinates of the shape's default mapping: u in red, v in green, fractional parts.</summary>
    Uv,

    /// <summary>Shading normal, world space: (n + 1) / 2.</summary>
    Normal,

    /// <summary>Distance d from the camera as grey 1 / (1 + d): near is bright.</summary>
    Depth,

    /// <summary>A colour for each object.</summary>
    Object,

    /// <summary>Magenta where the colour is NaN or infinite, else a dim grey of the colour.</summary>
    Nan,
}
