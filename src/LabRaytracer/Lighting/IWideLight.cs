namespace LabRaytracer;

/// <summary>A lamp that lights many points at a time, with the same bits as one at a time.</summary>
internal interface IWideLight
{
    /// <summary>The light that arrives at the first <paramref name="packets"/> groups of lanes.</summary>
    /// <param name="surfaces">The points.</param>
    /// <param name="samples">Where the samples go.</param>
    /// <param name="packets">Groups of lanes.</param>
    void Sample<R, F, I>(SurfaceBatch<R, F, I> surfaces, in LightColumns<R, F> samples, int packets)
        where R : unmanaged, ILane<R, F, I>
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I>;
}
