namespace LabRaytracer;

/// <summary>How a <see cref="Texture"/> is looked up.</summary>
/// <remarks>Immutable, thread safe.</remarks>
public sealed class SamplingOptions
{
    private readonly TextureFilter _filter = TextureFilter.Bilinear;
    private readonly TexelConvention _texels = TexelConvention.Center;
    private readonly TextureWrap? _wrapU;
    private readonly TextureWrap? _wrapV;

    /// <summary>Bilinear between texel centres, wrap as the mapping suggests.</summary>
    public static SamplingOptions Default { get; } = new();

    /// <summary>Filter. Default: bilinear.</summary>
    /// <exception cref="ArgumentOutOfRangeException">Not a value of the enumeration.</exception>
    public TextureFilter Filter
    {
        get => _filter;
        init => _filter = PropertyChecks.Known(value);
    }

    /// <summary>Where texels lie. Default: centres.</summary>
    /// <exception cref="ArgumentOutOfRangeException">Not a value of the enumeration.</exception>
    public TexelConvention Texels
    {
        get => _texels;
        init => _texels = PropertyChecks.Known(value);
    }

    /// <summary>Wrap in u; null (default): as the mapping suggests.</summary>
    /// <exception cref="ArgumentOutOfRangeException">Not a value of the enumeration.</exception>
    public TextureWrap? WrapU
    {
        get => _wrapU;
        init => _wrapU = value is { } wrap ? PropertyChecks.Known(wrap) : null;
    }

    /// <summary>Wrap in v; null (default): as the mapping suggests.</summary>
    /// <exception cref="ArgumentOutOfRangeException">Not a value of the enumeration.</exception>
    public TextureWrap? WrapV
    {
        get => _wrapV;
        init => _wrapV = value is { } wrap ? PropertyChecks.Known(wrap) : null;
    }

    /// <summary>What a wrap of <see cref="TextureWrap.Border"/> shows outside the picture: linear light in colour slots, numbers as they are in data slots. Default: black.</summary>
    /// <remarks>The alpha there is 0 whatever the colour, so that layers show what is below them. Slopes of a height map do not see it.</remarks>
    public Intensity BorderColor { get; init; } = Intensity.Black;

    /// <summary>How numbers become linear colour. Default: automatic.</summary>
    /// <exception cref="ArgumentOutOfRangeException">Not a value of the enumeration.</exception>
    public ColorSpace ColorSpace { get; init => field = PropertyChecks.Known(value); } = ColorSpace.Auto;

    /// <summary>The same options with another filter.</summary>
    public SamplingOptions With(TextureFilter filter) => new()
    {
        Filter = filter, Texels = Texels, WrapU = WrapU, WrapV = WrapV, BorderColor = BorderColor, ColorSpace = ColorSpace,
    };
}
