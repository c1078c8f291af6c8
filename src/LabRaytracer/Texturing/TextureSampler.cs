namespace LabRaytracer;

/// <summary>A texture made ready for one render: looked up many points at a time.</summary>
internal abstract unsafe class TextureSampler
{
    private long _fallbacks;

    /// <summary>Threads that may build what lookups need, here and in the sources, at least 1.</summary>
    public int Threads
    {
        get;
        set
        {
            field = value;
            foreach (TextureSampler source in Sources)
            {
                source.Threads = value;
            }
        }
    } = 1;

    /// <summary>Lookups so far, here and in the sources, whose footprint was too long for its width: they were filtered too softly.</summary>
    public long Fallbacks => Volatile.Read(ref _fallbacks) + Sources.Sum(source => source.Fallbacks);

    /// <summary>The samplers that this one looks up, which are its own.</summary>
    protected virtual IReadOnlyList<TextureSampler> Sources => [];

    /// <summary>Counts such lookups.</summary>
    protected void CountFallbacks(int count) => Interlocked.Add(ref _fallbacks, count);

    /// <summary>Colours of the first <paramref name="packets"/> groups of lanes.</summary>
    /// <param name="lookups">Where.</param>
    /// <param name="colors">Where the colours go.</param>
    /// <param name="packets">Groups of lanes.</param>
    public abstract void Sample<R, F, I>(in LookupBatch<R> lookups, in ColorColumns<F> colors, int packets)
        where R : unmanaged, ILane<R, F, I>
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I>;

    /// <summary>The axes of a picture's texels under a mapping; null of a texture that is no picture.</summary>
    public virtual (TexelAxis Across, TexelAxis Up)? FindAxes(IMapping mapping) => null;
}
