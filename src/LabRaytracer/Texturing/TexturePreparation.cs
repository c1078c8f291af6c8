namespace LabRaytracer;

/// <summary>Makes the textures of one render ready: each once, those that are used and no others.</summary>
/// <param name="filter">Filter that overrides the textures' own, or null.</param>
internal sealed class TexturePreparation(TextureFilter? filter)
{
    private readonly Dictionary<(ITexture Texture, TextureUse Use), TextureSampler> _samplers = [];
    private readonly Dictionary<(ITexture Texture, TextureChannel Channel, TextureWrap WrapU, TextureWrap WrapV), TextureSampler> _slopes = [];

    private int _threads = 1;

    /// <summary>Lookups whose footprint was too long for its width.</summary>
    public long Fallbacks => _samplers.Values.Concat(_slopes.Values).Sum(sampler => sampler.Fallbacks);

    /// <summary>Number of textures made ready.</summary>
    public int Count => _samplers.Count;

    /// <summary>Decodes files and packs texels of several textures at once, so that later calls find them.</summary>
    /// <param name="uses">Textures and what is read of them.</param>
    /// <param name="threads">Threads, at least 1.</param>
    public void PrepareAll(IEnumerable<(ITexture Texture, TextureUse Use)> uses, int threads)
    {
        (ITexture Texture, TextureUse Use)[] open = [.. uses.Distinct().Where(use => use.Texture.Needs != TextureNeeds.None && !_samplers.ContainsKey(use))];
        _threads = threads;
        TextureSampler[] ready = new TextureSampler[open.Length];
        try
        {
            Parallel.For(0, open.Length, new ParallelOptions { MaxDegreeOfParallelism = threads }, i => ready[i] = Create(open[i].Texture, open[i].Use));
        }
        catch (AggregateException failure)
        {
            // The first failed texture in the scene's order, so that the message does not depend on timing.
            throw failure.Flatten().InnerExceptions[0];
        }

        for (int i = 0; i < open.Length; i++)
        {
            _samplers[open[i]] = ready[i];
        }
    }

    /// <summary>What a texture must know of a hit under the filter of this render.</summary>
    public TextureNeeds Needs(ITexture texture) => texture is IPreparedTexture prepared ? prepared.NeedsUnder(filter) : texture.Needs;

    /// <summary>The texture made ready.</summary>
    public TextureSampler Prepare(ITexture texture, TextureUse use)
    {
        if (!_samplers.TryGetValue((texture, use), out TextureSampler? sampler))
        {
            sampler = Create(texture, use);
            _samplers[(texture, use)] = sampler;
        }

        return sampler;
    }

    /// <summary>The slopes of a texture's heights made ready.</summary>
    /// <param name="texture">The texture.</param>
    /// <param name="channel">Which channel is the height.</param>
    /// <param name="mapping">The mapping whose wraps it has by default.</param>
    public TextureSampler PrepareSlopes(ITexture texture, TextureChannel channel, IMapping mapping)
    {
        (ITexture, TextureChannel, TextureWrap, TextureWrap) key = (texture, channel, mapping.DefaultWrapU, mapping.DefaultWrapV);
        if (!_slopes.TryGetValue(key, out TextureSampler? sampler))
        {
            TextureUse use = channel == TextureChannel.Alpha ? TextureUse.Alpha : TextureUse.Data;
            sampler = texture is IPreparedTexture prepared
                ? prepared.PrepareSlopes(channel, mapping.DefaultWrapU, mapping.DefaultWrapV, filter)
                : new SlopeSampler(new CustomSampler(texture, use), channel, SlopeSampler.SpaceOf(texture));
            sampler.Threads = _threads;
            _slopes[key] = sampler;
        }

        return sampler;
    }

    private TextureSampler Create(ITexture texture, TextureUse use)
    {
        TextureSampler sampler = texture is IPreparedTexture prepared ? prepared.Prepare(use, filter) : new CustomSampler(texture, use);
        sampler.Threads = _threads;
        return sampler;
    }
}
