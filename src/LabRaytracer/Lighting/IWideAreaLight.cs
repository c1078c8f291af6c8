namespace LabRaytracer;

/// <summary>A lamp of some extent that lights many points at a time, with the same bits as one at a time.</summary>
internal interface IWideAreaLight
{
    /// <summary>One of the lamp's samples for the first <paramref name="packets"/> groups of lanes: the share of one sample, not of the whole lamp.</summary>
    /// <param name="surfaces">The points.</param>
    /// <param name="places">Where on the lamp each point's sample lies.</param>
    /// <param name="samples">Where the samples go.</param>
    /// <param name="packets">Groups of lanes.</param>
    void Sample<R, F, I>(SurfaceBatch<R, F, I> surfaces, in SquareColumns<R> places, in LightColumns<R, F> samples, int packets)
        where R : unmanaged, ILane<R, F, I>
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I>;
}
