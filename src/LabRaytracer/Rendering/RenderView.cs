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

    /// <summary>
    /// The texel that nearest lookup reads of the first picture texture of the material, diffuse before the other coefficients: a colour for each texel,
    /// light and dark in turn; grey without a picture texture, black outside of one with a border.
    /// </summary>
    Texel,

    /// <summary>
    /// Number of rays (from the camera, reflected, refracted, to lamps) that a sample of the pixel causes on average: black 1, blue 4, red 16, yellow 64, white 256 or more.
    /// </summary>
    Cost,

    /// <summary>
    /// A dim grey of the colour, red where u of the default mapping differs by more than 1/2 between the centres of a pixel and of a neighbour beside, above or below it
    /// on the same object: at seams, at poles, and where a pixel spans more than half of a texture.
    /// </summary>
    Seam,

    /// <summary>Number of samples of each pixel: black 1, blue 4, red 16, yellow 64, white 256 or more. Of interest with <see cref="RenderOptions.ErrorBudget"/>.</summary>
    Samples,

    /// <summary>
    /// How many texels of the first picture texture of the material (as for <see cref="Texel"/>) a sample covers in its longer direction, n, as colour of the level log2 n:
    /// white 0, red 1, yellow 2, green 3, cyan 4, blue 5, violet 6 and more; dark grey where the picture is enlarged, grey without a picture texture.
    /// </summary>
    Mip,

    /// <summary>How many times as long as wide a sample is on that texture: black 1, blue 4, red 16, yellow 64, white 256 or more; grey without a picture texture.</summary>
    Stretch,

    /// <summary>
    /// How many texels of that texture a sample covers, in area: white where it is one; magnified towards cyan 1/4, blue 1/16, dark blue 1/64 and less; more texels than
    /// samples towards yellow 4, red 16, dark red 64 and more; grey without a picture texture. With one sample a pixel this is texels a pixel.
    /// </summary>
    Density,
}
