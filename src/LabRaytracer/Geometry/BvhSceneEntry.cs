namespace LabRaytracer;

/// <summary>An object as the top-level tree knows it: a member of a group.</summary>
internal readonly record struct BvhSceneEntry<R, F, I>(ShapeGroup<R, F, I> Group, int Member)
    where R : unmanaged, ILane<R, F, I>
    where F : unmanaged, ILane<F, F, I>
    where I : unmanaged, IIndexLane<I>
{
    /// <summary>Keeps nearest hits where there is a batch for them, else blocks rays.</summary>
    public void Visit(RayBatch<R, F, I> rays, HitBatch<R, F, I>? hits, int firstPacket, int endPacket)
    {
        if (hits == null)
        {
            Group.Block(Member, rays, firstPacket, endPacket);
        }
        else
        {
            Group.Nearest(Member, rays, hits, firstPacket, endPacket);
        }
    }
}
