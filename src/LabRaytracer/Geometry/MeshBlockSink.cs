namespace LabRaytracer;

/// <summary>Ends every ray that is hit before its limit.</summary>
internal struct MeshBlockSink<R> : IMeshSink<R>
    where R : unmanaged, IReal<R>
{
    /// <summary>Mask of the rays that were hit.</summary>
    public R Blocked;

    public bool Take(in R mask, in R t, in R weight1, in R weight2, int triangle, ref R limit)
    {
        R blocked = mask & R.Less(t, limit);
        Blocked |= blocked;
        limit = R.Select(blocked, R.Of(-1), limit);
        return R.Any(blocked);
    }
}
