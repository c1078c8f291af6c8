namespace LabRaytracer;

/// <summary>What a search with several rays that go their own ways does at the leaves.</summary>
internal interface IBvhCrowdLeaf
{
    /// <summary>The items, which will be expected soon.</summary>
    unsafe byte* Items { get; }

    /// <summary>Says that the items at places [first, first + last] will be tested soon.</summary>
    /// <param name="first">First place.</param>
    /// <param name="last">Number of items less 1, 0 to 3.</param>
    void Expect(int first, int last);

    /// <summary>Tests the items at places [first, first + count) of the tree's order.</summary>
    /// <param name="crowd">Whose rays.</param>
    /// <param name="first">First place.</param>
    /// <param name="count">Number of items, 1 to 4.</param>
    /// <param name="rays">Bits of the rays that may meet them, at least one.</param>
    void Visit(int crowd, int first, int count, uint rays);
}
