namespace LabRaytracer;

/// <summary>Finds which objects rays meet: a plain loop over a handful of shapes and the unbounded ones, a tree over many.</summary>
internal sealed class ObjectSearch<R, F, I>
    where R : unmanaged, ILane<R, F, I>
    where F : unmanaged, ILane<F, F, I>
    where I : unmanaged, IIndexLane<I>
{
    private readonly ObjectEntry<R, F, I>[] _loop;

    public ObjectSearch(IReadOnlyList<ObjectEntry<R, F, I>> entries, LaneMemory memory, int threads)
    {
        _loop = [.. entries];
    }

    /// <summary>Keeps the nearest hit of every ray.</summary>
    public void Nearest(RayBatch<R, F, I> rays, HitBatch<R, F, I> hits)
    {
        foreach (ObjectEntry<R, F, I> entry in _loop)
        {
            entry.Group.Nearest(entry.Member, rays, hits, 0, rays.Packets);
        }
    }

    /// <summary>Turns off the rays that are blocked.</summary>
    public void Block(RayBatch<R, F, I> rays)
    {
        foreach (ObjectEntry<R, F, I> entry in _loop)
        {
            entry.Group.Block(entry.Member, rays, 0, rays.Packets);
        }
    }
}
