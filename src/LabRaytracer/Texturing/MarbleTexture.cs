using System.Runtime.CompilerServices;

namespace LabRaytracer;

/// <summary>Marble (Polish: marmur): parallel veins, bent by noise.</summary>
/// <remarks>
/// <para>t = (1 + sin(2 pi (stripes y + amount n(frequency p)))) / 2, [0, 1], with n the noise and y the second coordinate; the ramp makes colours of t.</para>
/// <para>Where the filter is wider than half a vein the sine gives way to 0, smoothly from a quarter on. Immutable, thread safe.</para>
/// </remarks>
public sealed class MarbleTexture : IPreparedTexture
{
    private readonly double _stripes = 2;
    private readonly double _frequency = 2;
    private readonly double _amount = 1;

    /// <summary>The noise that bends the veins. Default: six octaves of gradient noise.</summary>
    public Noise Noise { get; init => field = PropertyChecks.NotNull(value); } = new() { Octaves = 6 };

    /// <summary>Where the pattern lies. Default: in the object.</summary>
    public PatternSpace Space { get; init => field = PropertyChecks.Known(value); }

    /// <summary>Veins in one unit along y; 0 or more, finite. Default: 2.</summary>
    /// <exception cref="ArgumentOutOfRangeException">Negative or not finite.</exception>
    public double Stripes
    {
        get => _stripes;
        init => _stripes = PropertyChecks.NotNegative(value, "number of stripes of a marble");
    }

    /// <summary>Cells of the noise in one unit of the space; above 0, finite. Default: 2.</summary>
    /// <exception cref="ArgumentOutOfRangeException">Not a finite number above 0.</exception>
    public double Frequency
    {
        get => _frequency;
        init => _frequency = PropertyChecks.Positive(value, "frequency of a marble");
    }

    /// <summary>How far the noise bends the veins, in veins for a noise of 1; finite. Default: 1.</summary>
    /// <exception cref="ArgumentOutOfRangeException">Not finite.</exception>
    public double Amount
    {
        get => _amount;
        init => _amount = PropertyChecks.Finite(value, "amount of a marble's noise");
    }

    /// <summary>Colours from 0, the middle of a vein, to 1. Default: dark blue grey to white, most of it light.</summary>
    public ColorRamp Ramp { get; init => field = PropertyChecks.NotNull(value); } = new(
        new ColorStop(0, new Intensity(0.06f, 0.06f, 0.09f)), new ColorStop(0.35, new Intensity(0.55f, 0.55f, 0.58f)), new ColorStop(1, new Intensity(0.9f, 0.89f, 0.86f)));

    /// <summary>Width of the filter in footprints of the sample, [0, 16]; 0: none, and rays need not know their footprints. Default: 1.</summary>
    /// <exception cref="ArgumentOutOfRangeException">Outside [0, 16] or NaN.</exception>
    public double FilterWidth { get; init => field = PropertyChecks.FilterWidth(value); } = 1;

    /// <inheritdoc/>
    public TextureNeeds Needs => PatternSampler.Needs(Space, FilterWidth);

    /// <inheritdoc/>
    public Intensity Sample(in TextureLookup lookup) => PatternSampler.Sample(new Pattern(this), Space, FilterWidth, Ramp, lookup);

    TextureSampler IPreparedTexture.Prepare(TextureUse use, TextureFilter? filter) => new PatternSampler<Pattern>(new Pattern(this), Space, FilterWidth, Ramp);

    private readonly struct Pattern(MarbleTexture texture) : IPattern
    {
        [MethodImpl(MethodImplOptions.NoInlining)]
        public F At<R, F, I>(in PatternPoint<R, F> point, out F kept)
            where R : unmanaged, ILane<R, F, I>
            where F : unmanaged, ILane<F, F, I>
            where I : unmanaged, IIndexLane<I>
        {
            kept = F.Of(1);
            R scale = R.Of(texture.Frequency);
            F noise = texture.Noise.At<R, F, I>(point.X * scale, point.Y * scale, point.Z * scale, point.Width * F.Of(texture.Frequency), point.IsFlat);
            R phase = R.Fma(point.Y, R.Of(texture.Stripes), R.FromSingle(noise * F.Of(texture.Amount)));
            (F sine, _) = Elementary.SinCosTurns(R.ToSingle(phase - R.Floor(phase)));
            F still = FilterFade.Kept(point.Width * F.Of(texture.Stripes));
            return F.Fma(sine * still, F.Of(0.5), F.Of(0.5));
        }
    }
}
