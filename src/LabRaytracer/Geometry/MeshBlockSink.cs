namespace LabRaytracer;

/// <summary>Ends every ray that is hit before its limit, but not by the triangle that it leaves.</summary>
/// <param name="source">Numbers of the triangles that the rays leave, or -1.</param>
internal struct MeshBlockSink<R, F, I>(in I source) : IMeshSink<R>
    where R : unmanaged, ILane<R, F, I>
    where F : unmanaged, ILane<F, F, I>
    where I : unmanaged, IIndexLane<I>
{
    /// <summary>Mask of the rays that were hit.</summary>
    public R Blocked;

    private readonly I _source = source;

    public bool Take(in R mask, in R t, in R weight1, in R weight2, int triangle, ref R limit)
    {
        R blocked = mask & R.Less(t, limit) & ~R.MaskFromInt32(I.Equal(_source, I.Of(triangle)));
        Blocked |= blocked;
        limit = R.Select(blocked, R.Of(-1), limit);
        return R.Any(blocked);
    }
}
