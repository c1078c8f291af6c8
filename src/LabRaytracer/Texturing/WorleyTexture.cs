using System.Runtime.CompilerServices;

namespace LabRaytracer;

/// <summary>Cells around random points (Worley, Voronoi): stones, scales, cracked mud.</summary>
/// <remarks>
/// <para>Every cell of a lattice has one random point. t = F1, F2 or F2 - F1, the distances from frequency p to the nearest and the second nearest of all points, in
/// cells; the search stops only when no farther cell can matter. The ramp makes colours of t. Euclidean distances in space are on average 0.52 (F1) and 0.72 (F2).</para>
/// <para>Where the filter is wider than half a cell the distance gives way to its mean, smoothly from a quarter on.</para>
/// <para>Immutable, thread safe.</para>
/// </remarks>
public sealed class WorleyTexture : IPreparedTexture
{
    private readonly double _frequency = 4;

    /// <summary>Which distance. Default: the nearest.</summary>
    public WorleyFeature Feature { get; init => field = PropertyChecks.Known(value); }

    /// <summary>How distance is measured. Default: Euclidean.</summary>
    public WorleyMetric Metric { get; init => field = PropertyChecks.Known(value); }

    /// <summary>Where the pattern lies. Default: in the object.</summary>
    public PatternSpace Space { get; init => field = PropertyChecks.Known(value); }

    /// <summary>Cells in one unit of the space; above 0, finite. Default: 4.</summary>
    /// <exception cref="ArgumentOutOfRangeException">Not a finite number above 0.</exception>
    public double Frequency
    {
        get => _frequency;
        init => _frequency = PropertyChecks.Positive(value, "frequency of a cell texture");
    }

    /// <summary>Chooses one of many patterns; any number. Default: 0.</summary>
    public int Seed { get; init; }

    /// <summary>Colours of the distances, in cells. Default: black at 0 to white at 1.</summary>
    public ColorRamp Ramp { get; init => field = PropertyChecks.NotNull(value); } = ColorRamp.Grey;

    /// <summary>Width of the filter in footprints of the sample, [0, 16]; 0: none, and rays need not know their footprints. Default: 1.</summary>
    /// <exception cref="ArgumentOutOfRangeException">Outside [0, 16] or NaN.</exception>
    public double FilterWidth { get; init => field = PropertyChecks.FilterWidth(value); } = 1;

    /// <inheritdoc/>
    public TextureNeeds Needs => PatternSampler.Needs(Space, FilterWidth);

    /// <inheritdoc/>
    public Intensity Sample(in TextureLookup lookup) => PatternSampler.Sample(new Pattern(this), Space, FilterWidth, Ramp, lookup);

    TextureSampler IPreparedTexture.Prepare(TextureUse use, TextureFilter? filter) => new PatternSampler<Pattern>(new Pattern(this), Space, FilterWidth, Ramp);

    private readonly struct Pattern(WorleyTexture texture) : IPattern
    {
        [MethodImpl(MethodImplOptions.NoInlining)]
        public F At<R, F, I>(in PatternPoint<R, F> point, out F kept)
            where R : unmanaged, ILane<R, F, I>
            where F : unmanaged, ILane<F, F, I>
            where I : unmanaged, IIndexLane<I>
        {
            kept = F.Of(1);
            F still = FilterFade.Kept(point.Width * F.Of(texture.Frequency));
            F mean = F.Of(Mean(point.IsFlat));
            if (!F.Any(F.Less(F.Zero, still)))
            {
                return mean;
            }

            R scale = R.Of(texture.Frequency);
            PatternPoint<R, F> cell = new(point.X * scale, point.Y * scale, point.Z * scale, F.Zero, point.IsFlat);
            FeaturePoints.Nearest<R, F, I>(cell, CellHash.Key(texture.Seed, 0), texture.Metric, out F first, out F second);
            F here = texture.Feature switch
            {
                WorleyFeature.F1 => first,
                WorleyFeature.F2 => second,
                _ => second - first,
            };
            return FilterFade.Mix(mean, here, still);
        }

        /// <summary>The mean of the distance over all points, measured on 30000 of them.</summary>
        private double Mean(bool isFlat)
        {
            (double first, double second) = (texture.Metric, isFlat) switch
            {
                (WorleyMetric.Euclidean, false) => (0.524, 0.720),
                (WorleyMetric.Euclidean, true) => (0.430, 0.699),
                (WorleyMetric.Manhattan, false) => (0.770, 1.056),
                (WorleyMetric.Manhattan, true) => (0.540, 0.877),
                (_, false) => (0.423, 0.581),
                _ => (0.382, 0.621),
            };
            return texture.Feature switch
            {
                WorleyFeature.F1 => first,
                WorleyFeature.F2 => second,
                _ => second - first,
            };
        }
    }
}
