namespace LabRaytracer;

/// <summary>Chooses the group of a kernel.</summary>
internal static class KernelGroups
{
    /// <summary>A group of untransformed shapes where the transform is the identity, else one that takes rays to object space first.</summary>
    public static ShapeGroup<R, F, I> Create<K, R, F, I>(Transform transform)
        where K : struct, IShapeKernel
        where R : unmanaged, ILane<R, F, I>
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I> => transform.IsIdentity
            ? new KernelGroup<K, R, F, I>()
            : new KernelGroup<TransformedKernel<K>, R, F, I>();
}
