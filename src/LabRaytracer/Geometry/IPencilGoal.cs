namespace LabRaytracer;

/// <summary>What a pencil of rays looks for.</summary>
/// <typeparam name="R">Lane type of geometry.</typeparam>
/// <typeparam name="F">Float lanes of the same width.</typeparam>
/// <typeparam name="I">Integer lanes of the same width.</typeparam>
internal interface IPencilGoal<R, F, I>
    where R : unmanaged, ILane<R, F, I>
    where F : unmanaged, ILane<F, F, I>
    where I : unmanaged, IIndexLane<I>
{
    /// <summary>Whether near triangles should come first.</summary>
    static abstract bool IsOrdered { get; }

    /// <summary>Mask of rays that leave a triangle, and cannot hit it.</summary>
    /// <param name="lanes">The lanes.</param>
    /// <param name="number">Number of the triangle in the mesh.</param>
    static abstract F Leaves(in PencilLanes<R, F, I> lanes, int number);

    /// <summary>Sets the limits of lanes along z, before the first triangle.</summary>
    /// <param name="lanes">The lanes.</param>
    /// <param name="pencil">Their pencil.</param>
    /// <param name="packet">Which group of lanes they are, from 0.</param>
    void Start(ref PencilLanes<R, F, I> lanes, in RayPencil pencil, int packet);

    /// <summary>Takes what is known of a triangle; what is open is decided by the exact test.</summary>
    /// <param name="lanes">The lanes.</param>
    /// <param name="packet">Which group of lanes they are.</param>
    /// <param name="hits">Where they meet the triangle.</param>
    /// <param name="place">Place of the triangle in the tree's order.</param>
    /// <returns>Whether a limit was lowered.</returns>
    bool Take(ref PencilLanes<R, F, I> lanes, int packet, in PencilHits<F> hits, int place);

    /// <summary>Brings what was found into its final form, after the last triangle.</summary>
    void End(ref PencilLanes<R, F, I> lanes, int packet);
}
