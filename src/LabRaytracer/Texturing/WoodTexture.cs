using System.Runtime.CompilerServices;

namespace LabRaytracer;

/// <summary>Wood (Polish: drewno): rings around the y axis, bent by noise.</summary>
/// <remarks>
/// <para>r = rings sqrt(x² + z²) + amount n(frequency p), with n the noise; t = r - floor(r), [0, 1), the place inside of a ring; the ramp makes colours of t.
/// In texture space z is 0: boards instead of rings.</para>
/// <para>Where the filter is wider than half a ring the colour gives way to the ramp's mean, smoothly from a quarter on. Immutable, thread safe.</para>
/// </remarks>
public sealed class WoodTexture : IPreparedTexture
{
    private readonly double _rings = 8;
    private readonly double _frequency = 2;
    private readonly double _amount = 0.5;

    /// <summary>The noise that bends the rings. Default: three octaves of gradient noise.</summary>
    public Noise Noise { get; init => field = PropertyChecks.NotNull(value); } = new() { Octaves = 3 };

    /// <summary>Where the pattern lies. Default: in the object.</summary>
    public PatternSpace Space { get; init => field = PropertyChecks.Known(value); }

    /// <summary>Rings in one unit; above 0, finite. Default: 8.</summary>
    /// <exception cref="ArgumentOutOfRangeException">Not a finite number above 0.</exception>
    public double Rings
    {
        get => _rings;
        init => _rings = PropertyChecks.Positive(value, "number of rings of a wood");
    }

    /// <summary>Cells of the noise in one unit of the space; above 0, finite. Default: 2.</summary>
    /// <exception cref="ArgumentOutOfRangeException">Not a finite number above 0.</exception>
    public double Frequency
    {
        get => _frequency;
        init => _frequency = PropertyChecks.Positive(value, "frequency of a wood");
    }

    /// <summary>How far the noise bends the rings, in rings for a noise of 1; finite. Default: 0.5.</summary>
    /// <exception cref="ArgumentOutOfRangeException">Not finite.</exception>
    public double Amount
    {
        get => _amount;
        init => _amount = PropertyChecks.Finite(value, "amount of a wood's noise");
    }

    /// <summary>Colours from the inner edge of a ring, 0, to the outer one, 1. Default: light, slowly darker, quickly light again.</summary>
    public ColorRamp Ramp { get; init => field = PropertyChecks.NotNull(value); } = new(
        new ColorStop(0, new Intensity(0.55f, 0.31f, 0.12f)), new ColorStop(0.8, new Intensity(0.24f, 0.1f, 0.03f)), new ColorStop(1, new Intensity(0.55f, 0.31f, 0.12f)));

    /// <summary>Width of the filter in footprints of the sample, [0, 16]; 0: none, and rays need not know their footprints. Default: 1.</summary>
    /// <exception cref="ArgumentOutOfRangeException">Outside [0, 16] or NaN.</exception>
    public double FilterWidth { get; init => field = PropertyChecks.FilterWidth(value); } = 1;

    /// <inheritdoc/>
    public TextureNeeds Needs => PatternSampler.Needs(Space, FilterWidth);

    /// <inheritdoc/>
    public Intensity Sample(in TextureLookup lookup) => PatternSampler.Sample(new Pattern(this), Space, FilterWidth, Ramp, lookup);

    TextureSampler IPreparedTexture.Prepare(TextureUse use, TextureFilter? filter) => new PatternSampler<Pattern>(new Pattern(this), Space, FilterWidth, Ramp);

    private readonly struct Pattern(WoodTexture texture) : IPattern
    {
        [MethodImpl(MethodImplOptions.NoInlining)]
        public F At<R, F, I>(in PatternPoint<R, F> point, out F kept)
            where R : unmanaged, ILane<R, F, I>
            where F : unmanaged, ILane<F, F, I>
            where I : unmanaged, IIndexLane<I>
        {
            R scale = R.Of(texture.Frequency);
            F noise = texture.Noise.At<R, F, I>(point.X * scale, point.Y * scale, point.Z * scale, point.Width * F.Of(texture.Frequency), point.IsFlat);
            R ring = R.Fma(Elementary.Hypotenuse(point.X, point.Z), R.Of(texture.Rings), R.FromSingle(noise * F.Of(texture.Amount)));
            kept = FilterFade.Kept(point.Width * F.Of(texture.Rings));
            return R.ToSingle(ring - R.Floor(ring));
        }
    }
}
