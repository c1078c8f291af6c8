namespace LabRaytracer;

/// <summary>A texture over a coefficient that is already there: one of a stack of layers (paint over a wall), or a decal (a sticker).</summary>
/// <remarks>
/// <para>k' = k + opacity alpha (blend(k, T) - k), where T and alpha are the texture's. With the default blend, replace, that is "T over k" (Porter and Duff 1984).
/// Colours are filtered as products with alpha, so that texels of alpha 0 do not tint the edges.</para>
/// <para>Immutable, thread safe.</para>
/// </remarks>
public sealed class TextureLayer
{
    /// <summary>Creates a layer that shows a texture as it is.</summary>
    /// <param name="texture">The texture; what is not there of it (alpha, border) shows what is below.</param>
    public TextureLayer(ITexture texture) => Texture = texture ?? throw new ArgumentNullException(nameof(texture));

    /// <summary>The texture.</summary>
    public ITexture Texture { get; }

    /// <summary>How the surface is mapped; null (default): as the shape suggests.</summary>
    public IMapping? Mapping { get; init; }

    /// <summary>Transform of (u, v) before the lookup. Default: none.</summary>
    public UvTransform Transform { get; init => field = PropertyChecks.NotNull(value); } = UvTransform.Identity;

    /// <summary>Factor of the texture's alpha, [0, 1]. Default: 1.</summary>
    /// <exception cref="ArgumentOutOfRangeException">Outside [0, 1] or NaN.</exception>
    public float Opacity
    {
        get;
        init => field = value is >= 0 and <= 1
            ? value
            : throw new ArgumentOutOfRangeException(nameof(value), value, "The opacity of a layer must be in [0, 1].");
    } = 1;

    /// <summary>What becomes of the value below where the layer is opaque. Default: replaced.</summary>
    public BlendMode Blend { get; init => field = PropertyChecks.Known(value); } = BlendMode.Replace;

    /// <summary>Tells whether the texture is there once: nothing of it outside [0, 1] x [0, 1] after the transform. Default: no, its wrap decides.</summary>
    public bool IsDecal { get; init; }

    /// <summary>A picture stuck onto a surface once.</summary>
    /// <param name="texture">The picture.</param>
    /// <param name="center">Its centre in the surface's (u, v).</param>
    /// <param name="size">Its width and height in u and v; above 0.</param>
    /// <param name="rotationDegrees">Its turn, counter-clockwise with v up, degrees.</param>
    /// <exception cref="ArgumentException">A size is not above 0, or a number is not finite.</exception>
    public static TextureLayer Decal(ITexture texture, TextureCoordinate center, TextureCoordinate size, double rotationDegrees = 0) =>
        new(texture) { Transform = UvTransform.Placing(center, size, rotationDegrees), IsDecal = true };

    /// <summary>The value above the layer.</summary>
    /// <param name="below">The value below it.</param>
    /// <param name="texel">Colour of the texture, not multiplied by alpha.</param>
    /// <param name="alpha">Alpha of the texture, [0, 1].</param>
    public Intensity Apply(Intensity below, Intensity texel, float alpha)
    {
        CompiledLayer layer = new(-1, -1, -1, texel * alpha, alpha, Blend, Opacity);
        return new Intensity(
            layer.Apply(new Float1(below.R), new Float1(layer.Color.R), new Float1(alpha)).Value,
            layer.Apply(new Float1(below.G), new Float1(layer.Color.G), new Float1(alpha)).Value,
            layer.Apply(new Float1(below.B), new Float1(layer.Color.B), new Float1(alpha)).Value);
    }
}
