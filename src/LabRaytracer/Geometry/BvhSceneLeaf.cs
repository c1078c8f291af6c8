namespace LabRaytracer;

/// <summary>The objects of a scene: what a leaf of the top-level tree asks.</summary>
/// <typeparam name="R">Lane type of geometry.</typeparam>
/// <typeparam name="F">Float lanes of the same width.</typeparam>
/// <typeparam name="I">Integer lanes of the same width.</typeparam>
/// <param name="entries">The objects in the order of the leaves.</param>
/// <param name="rays">The rays.</param>
/// <param name="hits">Where nearest hits are kept, or null to block rays.</param>
/// <param name="packet">The group of lanes.</param>
internal readonly unsafe struct BvhSceneLeaf<R, F, I>(
    BvhSceneEntry<R, F, I>[] entries, RayBatch<R, F, I> rays, HitBatch<R, F, I>? hits, int packet) : IBvhLeaf<R>
    where R : unmanaged, ILane<R, F, I>
    where F : unmanaged, ILane<F, F, I>
    where I : unmanaged, IIndexLane<I>
{
    public bool Visit(int first, int count, ref R limit)
    {
        for (int i = first; i < first + count; i++)
        {
            entries[i].Visit(rays, hits, packet, packet + 1);
        }

        R known = hits == null ? rays.Limit[packet] : hits.T[packet];
        R lowered = R.Less(known, limit);
        limit = R.Select(lowered, known, limit);
        return R.Any(lowered);
    }
}
