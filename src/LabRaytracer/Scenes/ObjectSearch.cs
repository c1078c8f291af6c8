namespace LabRaytracer;

/// <summary>Finds which objects rays meet: a plain loop over a handful of shapes and the unbounded ones, a tree over many.</summary>
internal sealed class ObjectSearch<R, F, I>
    where R : unmanaged, ILane<R, F, I>
    where F : unmanaged, ILane<F, F, I>
    where I : unmanaged, IIndexLane<I>
{
    /// <summary>Up to this many bounded objects a loop is faster than a tree.</summary>
    private const int LoopLimit = 8;

    private readonly ObjectEntry<R, F, I>[] _loop;
    private readonly SceneBvh<R, F, I>? _tree;

    public ObjectSearch(IReadOnlyList<ObjectEntry<R, F, I>> entries, LaneMemory memory, int threads)
    {
        ObjectEntry<R, F, I>[] bounded = [.. entries.Where(entry => entry.Bounds.IsFinite)];
        if (bounded.Length <= LoopLimit)
        {
            _loop = [.. entries];
            return;
        }

        _loop = [.. entries.Where(entry => !entry.Bounds.IsFinite)];
        _tree = new SceneBvh<R, F, I>(
            [.. bounded.Select(entry => entry.Bounds)], [.. bounded.Select(entry => entry.Group)], [.. bounded.Select(entry => entry.Member)], memory, threads);
    }

    /// <summary>Keeps the nearest hit of every ray.</summary>
    public void Nearest(RayBatch<R, F, I> rays, HitBatch<R, F, I> hits)
    {
        foreach (ObjectEntry<R, F, I> entry in _loop)
        {
            entry.Group.Nearest(entry.Member, rays, hits, 0, rays.Packets);
        }

        _tree?.Nearest(rays, hits, 0, rays.Packets);
    }

    /// <summary>Turns off the rays that are blocked.</summary>
    public void Block(RayBatch<R, F, I> rays)
    {
        foreach (ObjectEntry<R, F, I> entry in _loop)
        {
            entry.Group.Block(entry.Member, rays, 0, rays.Packets);
        }

        _tree?.Block(rays, 0, rays.Packets);
    }
}
