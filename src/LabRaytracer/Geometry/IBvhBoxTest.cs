namespace LabRaytracer;

/// <summary>A way to test rays against the box of a node.</summary>
/// <typeparam name="F">Float lanes.</typeparam>
internal interface IBvhBoxTest<F>
    where F : unmanaged, IReal<F>
{
    /// <summary>Tells whether any lane meets the box at a parameter of [0, limit].</summary>
    unsafe bool Meets(BvhNode* node, in BvhSlab<F> x, in BvhSlab<F> y, in BvhSlab<F> z, F limit);
}
