using System.Runtime.CompilerServices;

namespace LabRaytracer;

/// <summary>Two textures blended by the luminance of a third, many points at a time; what has no weight is not looked up.</summary>
/// <param name="first">Texture of the weight 0.</param>
/// <param name="second">Texture of the weight 1.</param>
/// <param name="weight">Texture whose luminance is the weight.</param>
/// <param name="threshold">Luminance from which the weight is 1, below it 0; null: the weight is the luminance itself.</param>
internal sealed unsafe class BlendSampler(TextureSampler first, TextureSampler second, TextureSampler weight, float? threshold) : TextureSampler
{
    protected override IReadOnlyList<TextureSampler> Sources => [first, second, weight];

    /// <summary>The colour at one point, with the same bits.</summary>
    public static Intensity Blend(ITexture first, ITexture second, Intensity weight, float? threshold, in TextureLookup lookup)
    {
        float share = Share(new Float1(weight.R), new Float1(weight.G), new Float1(weight.B), threshold).Value;
        return share <= 0 ? first.Sample(lookup) : share >= 1 ? second.Sample(lookup) : Intensity.Lerp(first.Sample(lookup), second.Sample(lookup), share);
    }

    public override void Sample<R, F, I>(in LookupBatch<R> lookups, in ColorColumns<F> colors, int packets)
    {
        F* memory = stackalloc F[9 * TextureParts.Chunk];
        ColorColumns<F> one = TextureParts.Columns(memory), other = TextureParts.Columns(memory + (3 * TextureParts.Chunk));
        F* shares = memory + (6 * TextureParts.Chunk);
        for (int start = 0; start < packets; start += TextureParts.Chunk)
        {
            int count = Math.Min(TextureParts.Chunk, packets - start);
            LookupBatch<R> part = lookups.Part(start, count);
            weight.Sample<R, F, I>(part, one, count);
            F least = F.Of(1), most = F.Zero;
            for (int i = 0; i < count; i++)
            {
                shares[i] = Share(one.R[i], one.G[i], one.B[i], threshold);
                least = F.Min(least, shares[i]);
                most = F.Max(most, shares[i]);
            }

            if (!F.All(F.LessOrEqual(F.Of(1), least)))
            {
                first.Sample<R, F, I>(part, one, count);
            }

            if (!F.All(F.LessOrEqual(most, F.Zero)))
            {
                second.Sample<R, F, I>(part, other, count);
            }

            for (int i = 0; i < count; i++)
            {
                colors.R[start + i] = Lerp(one.R[i], other.R[i], shares[i]);
                colors.G[start + i] = Lerp(one.G[i], other.G[i], shares[i]);
                colors.B[start + i] = Lerp(one.B[i], other.B[i], shares[i]);
            }
        }
    }

    /// <summary>The weight of a colour, [0, 1].</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static F Share<F>(F red, F green, F blue, float? threshold)
        where F : unmanaged, IReal<F>
    {
        F luminance = (F.Of(0.2126f) * red) + (F.Of(0.7152f) * green) + (F.Of(0.0722f) * blue);
        return threshold is { } least
            ? F.LessOrEqual(F.Of(least), luminance) & F.Of(1)
            : F.Min(F.Max(luminance, F.Zero), F.Of(1));
    }

    /// <summary>The ends exactly, so that it does not matter what stands in the column of a texture that was not looked up.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static F Lerp<F>(F first, F second, F share)
        where F : unmanaged, IReal<F>
    {
        F mixed = first + ((second - first) * share);
        return F.Select(F.LessOrEqual(share, F.Zero), first, F.Select(F.LessOrEqual(F.Of(1), share), second, mixed));
    }
}
