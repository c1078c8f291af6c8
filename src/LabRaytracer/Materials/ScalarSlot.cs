namespace LabRaytracer;

/// <summary>A number of a material (shininess, index of refraction): a value, optionally modulated by one channel of a texture.</summary>
/// <remarks>Immutable, thread safe. A number converts by itself: <c>Shininess = 50</c>. Textures here are data: their numbers are not sRGB-decoded by default.</remarks>
public sealed class ScalarSlot
{
    private readonly float _value;
    private readonly float _amount = 1;

    /// <summary>The number without texture; finite. Default: 0.</summary>
    /// <exception cref="ArgumentOutOfRangeException">NaN or infinite.</exception>
    public float Value
    {
        get => _value;
        init => _value = float.IsFinite(value)
            ? value
            : throw new ArgumentOutOfRangeException(nameof(value), value, "A material's number must be finite.");
    }

    /// <summary>The texture; null (default) for a constant.</summary>
    public ITexture? Texture { get; init; }

    /// <summary>Which channel of the texture is read. Default: luminance.</summary>
    public TextureChannel Channel { get; init => field = PropertyChecks.Known(value); }

    /// <summary>How the surface is mapped; null (default): as the shape suggests.</summary>
    public IMapping? Mapping { get; init; }

    /// <summary>Transform of (u, v) before the lookup. Default: none.</summary>
    public UvTransform Transform { get; init => field = PropertyChecks.NotNull(value); } = UvTransform.Identity;

    /// <summary>How much of the texture's effect is applied, [0, 1]. Default: 1.</summary>
    /// <exception cref="ArgumentOutOfRangeException">Outside [0, 1] or NaN.</exception>
    public float Amount
    {
        get => _amount;
        init => _amount = value is >= 0 and <= 1
            ? value
            : throw new ArgumentOutOfRangeException(nameof(value), value, "The amount of a texture must be in [0, 1].");
    }

    /// <summary>How the texture changes the value. Default: multiply.</summary>
    public BlendMode Blend { get; init => field = PropertyChecks.Known(value); }

    /// <summary>A constant number.</summary>
    public static implicit operator ScalarSlot(double value) => new() { Value = (float)value };

    /// <summary>The number of the chosen channel.</summary>
    /// <param name="texel">Colour of the texture, linear; where the channel is alpha, alpha as a grey.</param>
    public float Read(Intensity texel) => Channel switch
    {
        TextureChannel.Red or TextureChannel.Alpha => texel.R,
        TextureChannel.Green => texel.G,
        TextureChannel.Blue => texel.B,
        _ => texel.Luminance,
    };

    /// <summary>The number where the texture has a given colour: lerp(k, blend(k, channel of T), amount).</summary>
    public float Apply(Intensity texel)
    {
        float t = Read(texel);
        float blended = Blend switch
        {
            BlendMode.Multiply => Value * t,
            BlendMode.Replace => t,
            BlendMode.Add => Value + t,
            _ => Value + ((t - Value) * 0.5f),
        };
        return Amount == 1 ? blended : Value + ((blended - Value) * Amount);
    }
}
