namespace LabRaytracer;

/// <summary>A colour coefficient of a material: a value, optionally modulated by a texture.</summary>
/// <remarks>
/// <para>Lab sheet IV, section 1.1: the texture belongs to the material and modulates one of its coefficients:
/// k' = lerp(k, blend(k, T), amount), exactly blend(k, T) for amount 1.</para>
/// <para>Immutable, thread safe. A colour or a picture converts by itself: <c>Diffuse = Texture.Load("earth.png")</c>.</para>
/// </remarks>
public sealed class TextureSlot
{
    private readonly float _amount = 1;
    private readonly BlendMode _blend;

    /// <summary>The coefficient without texture, linear. Default: white, so that a texture alone shows as it is.</summary>
    public Intensity Value { get; init; } = Intensity.White;

    /// <summary>The texture; null (default) for a constant coefficient.</summary>
    public ITexture? Texture { get; init; }

    /// <summary>How the surface is mapped; null (default): as the shape suggests.</summary>
    public IMapping? Mapping { get; init; }

    /// <summary>Transform of (u, v) before the lookup. Default: none.</summary>
    public UvTransform Transform { get; init => field = PropertyChecks.NotNull(value); } = UvTransform.Identity;

    /// <summary>How much of the texture's effect is applied, [0, 1], both ends included. Default: 1.</summary>
    /// <exception cref="ArgumentOutOfRangeException">Outside [0, 1] or NaN.</exception>
    public float Amount
    {
        get => _amount;
        init => _amount = value is >= 0 and <= 1
            ? value
            : throw new ArgumentOutOfRangeException(nameof(value), value, "The amount of a texture must be in [0, 1].");
    }

    /// <summary>How the texture changes the value. Default: multiply.</summary>
    /// <exception cref="ArgumentOutOfRangeException">Not a value of the enumeration.</exception>
    public BlendMode Blend
    {
        get => _blend;
        init => _blend = PropertyChecks.Known(value);
    }

    /// <summary>Textures over the result of the slot's own one, from the bottom up: each with a mapping, transform and opacity of its own. Default: none.</summary>
    /// <exception cref="ArgumentNullException">The list or one of its layers is null.</exception>
    public IReadOnlyList<TextureLayer> Layers
    {
        get;
        init => field = [.. PropertyChecks.NotNull(value).Select(PropertyChecks.NotNull)];
    } = [];

    /// <summary>Tells whether the texture can change the coefficient: only then is it made ready and looked up.</summary>
    internal bool IsTextured => Texture is not null && Amount > 0 && !(Blend == BlendMode.Multiply && Value == Intensity.Black);

    /// <summary>A constant coefficient.</summary>
    public static implicit operator TextureSlot(Intensity value) => new() { Value = value };

    /// <summary>A picture, unchanged.</summary>
    public static implicit operator TextureSlot(Texture texture) => Of(texture);

    /// <summary>A texture of any kind, unchanged.</summary>
    public static TextureSlot Of(ITexture texture) => new() { Texture = texture ?? throw new ArgumentNullException(nameof(texture)) };

    /// <summary>The coefficient where the texture has a given colour, without layers: lerp(k, blend(k, T), amount).</summary>
    /// <param name="texel">Colour of the texture, linear.</param>
    public Intensity Apply(Intensity texel)
    {
        Intensity blended = Blend switch
        {
            BlendMode.Multiply => Value * texel,
            BlendMode.Replace => texel,
            BlendMode.Add => Value + texel,
            _ => Intensity.Lerp(Value, texel, 0.5f),
        };
        return Amount == 1 ? blended : Intensity.Lerp(Value, blended, Amount);
    }
}
