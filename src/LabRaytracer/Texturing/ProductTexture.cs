namespace LabRaytracer;

/// <summary>Two textures multiplied, component by component: one filters the other.</summary>
/// <remarks>Constants are folded when the texture is made ready: times black needs nothing of a hit. Immutable, thread safe if the parts are.</remarks>
public sealed class ProductTexture : IPreparedTexture
{
    /// <summary>The product of two textures.</summary>
    /// <param name="first">One factor.</param>
    /// <param name="second">The other factor.</param>
    /// <exception cref="ArgumentNullException">A factor is missing.</exception>
    public ProductTexture(ITexture first, ITexture second)
    {
        First = PropertyChecks.NotNull(first);
        Second = PropertyChecks.NotNull(second);
    }

    /// <summary>One factor.</summary>
    public ITexture First { get; }

    /// <summary>The other factor.</summary>
    public ITexture Second { get; }

    /// <inheritdoc/>
    public TextureNeeds Needs => IsBlack ? TextureNeeds.None : First.Needs | Second.Needs;

    private bool IsBlack => TextureParts.Constant(First) == Intensity.Black || TextureParts.Constant(Second) == Intensity.Black;

    /// <inheritdoc/>
    public Intensity Sample(in TextureLookup lookup) => IsBlack ? Intensity.Black : First.Sample(lookup) * Second.Sample(lookup);

    TextureSampler IPreparedTexture.Prepare(TextureUse use, TextureFilter? filter) => IsBlack
        ? new ConstantSampler(Intensity.Black)
        : new Sampler(TextureParts.Prepare(First, use, filter), TextureParts.Prepare(Second, use, filter));

    /// <summary>The product, many points at a time.</summary>
    private sealed unsafe class Sampler(TextureSampler first, TextureSampler second) : TextureSampler
    {
        protected override IReadOnlyList<TextureSampler> Sources => [first, second];

        public override void Sample<R, F, I>(in LookupBatch<R> lookups, in ColorColumns<F> colors, int packets)
        {
            F* memory = stackalloc F[3 * TextureParts.Chunk];
            ColorColumns<F> factor = TextureParts.Columns(memory);
            first.Sample<R, F, I>(lookups, colors, packets);
            for (int start = 0; start < packets; start += TextureParts.Chunk)
            {
                int count = Math.Min(TextureParts.Chunk, packets - start);
                second.Sample<R, F, I>(lookups.Part(start, count), factor, count);
                for (int i = 0; i < count; i++)
                {
                    colors.R[start + i] *= factor.R[i];
                    colors.G[start + i] *= factor.G[i];
                    colors.B[start + i] *= factor.B[i];
                }
            }
        }
    }
}
