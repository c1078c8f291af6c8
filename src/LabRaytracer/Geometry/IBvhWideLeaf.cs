namespace LabRaytracer;

/// <summary>What a search of a wide tree does at the leaves.</summary>
internal interface IBvhWideLeaf
{
    /// <summary>Says that the items from a place on are likely to be tested soon.</summary>
    /// <param name="first">First place.</param>
    void Expect(int first);

    /// <summary>Tests the items at places [first, first + count) of the tree's order.</summary>
    /// <param name="first">First place.</param>
    /// <param name="count">Number of items, 1 to 4.</param>
    /// <param name="box">Its smallest x in the planes of its parent (<see cref="BvhWideNode"/>).</param>
    /// <param name="limit">The limit in the units of boxes, rounded up; to be lowered, below 0 to end the search.</param>
    unsafe void Visit(int first, int count, float* box, ref float limit);
}
