namespace LabRaytracer;

/// <summary>Colours for the luminance of another texture: a picture or a pattern recoloured.</summary>
/// <remarks>color = ramp(luminance of the source). Immutable, thread safe if the source is.</remarks>
public sealed class RampTexture : IPreparedTexture
{
    /// <summary>A recoloured texture.</summary>
    /// <param name="source">Texture whose luminance is coloured.</param>
    /// <param name="ramp">The colours.</param>
    /// <exception cref="ArgumentNullException">The source or the ramp is missing.</exception>
    public RampTexture(ITexture source, ColorRamp ramp)
    {
        Source = PropertyChecks.NotNull(source);
        Ramp = PropertyChecks.NotNull(ramp);
    }

    /// <summary>Texture whose luminance is coloured.</summary>
    public ITexture Source { get; }

    /// <summary>The colours.</summary>
    public ColorRamp Ramp { get; }

    /// <inheritdoc/>
    public TextureNeeds Needs => Source.Needs;

    /// <inheritdoc/>
    public Intensity Sample(in TextureLookup lookup) => Ramp.At(Source.Sample(lookup).Luminance);

    TextureSampler IPreparedTexture.Prepare(TextureUse use, TextureFilter? filter) => new Sampler(TextureParts.Prepare(Source, TextureUse.Color, filter), Ramp);

    /// <summary>The colours, many points at a time.</summary>
    private sealed unsafe class Sampler(TextureSampler source, ColorRamp ramp) : TextureSampler
    {
        protected override IReadOnlyList<TextureSampler> Sources => [source];

        public override void Sample<R, F, I>(in LookupBatch<R> lookups, in ColorColumns<F> colors, int packets)
        {
            source.Sample<R, F, I>(lookups, colors, packets);
            for (int i = 0; i < packets; i++)
            {
                F luminance = (F.Of(0.2126f) * colors.R[i]) + (F.Of(0.7152f) * colors.G[i]) + (F.Of(0.0722f) * colors.B[i]);
                ramp.At(luminance, out colors.R[i], out colors.G[i], out colors.B[i]);
            }
        }
    }
}
