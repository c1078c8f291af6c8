namespace LabRaytracer;

/// <summary>All shapes of one class in a scene, packed for rendering.</summary>
/// <typeparam name="R">Lane type of geometry.</typeparam>
/// <typeparam name="F">Float lanes of the same width.</typeparam>
/// <typeparam name="I">Integer lanes of the same width.</typeparam>
internal abstract unsafe class ShapeGroup<R, F, I>
    where R : unmanaged, ILane<R, F, I>
    where F : unmanaged, ILane<F, F, I>
    where I : unmanaged, IIndexLane<I>
{
    /// <summary>Adds a shape under its object number in the scene; returns its number in the group.</summary>
    /// <param name="shape">A shape of the class that created the group.</param>
    /// <param name="transform">Object space to world space.</param>
    /// <param name="number">Number of the object in the scene.</param>
    public abstract int Add(Shape shape, Transform transform, int number);

    /// <summary>Packs the shapes once all are added (and builds what searches them).</summary>
    /// <param name="memory">Owns the packed numbers.</param>
    /// <param name="threads">Threads that may work on it, at least 1.</param>
    public abstract void Freeze(LaneMemory memory, int threads);

    /// <summary>Keeps the nearest hits of one member in groups of lanes [first, end).</summary>
    public abstract void Nearest(int member, RayBatch<R, F, I> rays, HitBatch<R, F, I> hits, int first, int end);

    /// <summary>Turns off (limit below 0) the rays in groups of lanes [first, end) that one member blocks before their limit.</summary>
    public abstract void Block(int member, RayBatch<R, F, I> rays, int first, int end);

    /// <summary>Tells whether a member may block some shadow rays; false only where <see cref="Block"/> is certain to block none. Default: it may.</summary>
    /// <param name="member">The member.</param>
    /// <param name="bounds">Bounds of the rays.</param>
    /// <param name="source">Number of the object whose outer side all of them leave, or -1.</param>
    public virtual bool MayBlock(int member, in RayBounds bounds, int source) => true;

    /// <summary>Surface points of hits on members of this group, world space.</summary>
    /// <param name="rays">The rays that hit.</param>
    /// <param name="hits">Their hits.</param>
    /// <param name="order">Numbers of the rays, padded to whole groups of lanes with valid numbers.</param>
    /// <param name="count">How many rays.</param>
    /// <param name="memberOfObject">The member number of each object number of this group.</param>
    /// <param name="surfaces">Where the surface points go, in the order of <paramref name="order"/>.</param>
    /// <param name="needs">Columns that somebody reads.</param>
    public abstract void Surface(
        RayBatch<R, F, I> rays, HitBatch<R, F, I> hits, int* order, int count, int* memberOfObject, SurfaceBatch<R, F, I> surfaces, SurfaceNeeds needs);

    /// <summary>What changes over steps in the tangent planes of hits on members of this group.</summary>
    /// <param name="rays">The rays that hit.</param>
    /// <param name="hits">Their hits.</param>
    /// <param name="order">Numbers of the rays, padded to whole groups of lanes with valid numbers.</param>
    /// <param name="count">How many rays.</param>
    /// <param name="memberOfObject">The member number of each object number of this group.</param>
    /// <param name="surfaces">Surface points of the hits with local points and shading normals of either sign, in the order of <paramref name="order"/>.</param>
    /// <param name="steps">Steps in world space, in that order; receives what changes over them.</param>
    /// <param name="needs">What somebody reads.</param>
    public abstract void Differentiate(
        RayBatch<R, F, I> rays, HitBatch<R, F, I> hits, int* order, int count, int* memberOfObject, SurfaceBatch<R, F, I> surfaces, SurfaceSteps<F> steps, StepNeeds needs);
}
