using System.Runtime.CompilerServices;

namespace LabRaytracer;

/// <summary>Noise as a texture: clouds, stains, rough surfaces.</summary>
/// <remarks>
/// t = (1 + n(frequency p)) / 2 for fractional Brownian motion, t = n(frequency p) for turbulence, both around [0, 1]; the ramp makes colours of t.
/// p is the local point or (u, v, 0). Immutable, thread safe.
/// </remarks>
public sealed class NoiseTexture : IPreparedTexture
{
    private readonly double _frequency = 4;

    /// <summary>The noise. Default: one octave of gradient noise.</summary>
    public Noise Noise { get; init => field = PropertyChecks.NotNull(value); } = new();

    /// <summary>Where the pattern lies. Default: in the object.</summary>
    public PatternSpace Space { get; init => field = PropertyChecks.Known(value); }

    /// <summary>Cells of the first octave in one unit of the space; above 0, finite. Default: 4.</summary>
    /// <exception cref="ArgumentOutOfRangeException">Not a finite number above 0.</exception>
    public double Frequency
    {
        get => _frequency;
        init => _frequency = PropertyChecks.Positive(value, "frequency of a noise");
    }

    /// <summary>Colours of the numbers from 0 to 1. Default: black to white.</summary>
    public ColorRamp Ramp { get; init => field = PropertyChecks.NotNull(value); } = ColorRamp.Grey;

    /// <summary>Width of the filter in footprints of the sample, [0, 16]; 0: none, and rays need not know their footprints. Default: 1.</summary>
    /// <exception cref="ArgumentOutOfRangeException">Outside [0, 16] or NaN.</exception>
    public double FilterWidth { get; init => field = PropertyChecks.FilterWidth(value); } = 1;

    /// <inheritdoc/>
    public TextureNeeds Needs => PatternSampler.Needs(Space, FilterWidth);

    /// <inheritdoc/>
    public Intensity Sample(in TextureLookup lookup) => PatternSampler.Sample(new Pattern(this), Space, FilterWidth, Ramp, lookup);

    TextureSampler IPreparedTexture.Prepare(TextureUse use, TextureFilter? filter) => new PatternSampler<Pattern>(new Pattern(this), Space, FilterWidth, Ramp);

    private readonly struct Pattern(NoiseTexture texture) : IPattern
    {
        [MethodImpl(MethodImplOptions.NoInlining)]
        public F At<R, F, I>(in PatternPoint<R, F> point, out F kept)
            where R : unmanaged, ILane<R, F, I>
            where F : unmanaged, ILane<F, F, I>
            where I : unmanaged, IIndexLane<I>
        {
            kept = F.Of(1);
            R scale = R.Of(texture.Frequency);
            F number = texture.Noise.At<R, F, I>(point.X * scale, point.Y * scale, point.Z * scale, point.Width * F.Of(texture.Frequency), point.IsFlat);
            return texture.Noise.Sum == NoiseSum.Turbulence ? number : F.Fma(number, F.Of(0.5), F.Of(0.5));
        }
    }
}
