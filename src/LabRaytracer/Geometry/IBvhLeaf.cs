namespace LabRaytracer;

/// <summary>What a search does at the leaves of a tree of boxes.</summary>
/// <typeparam name="R">Lane type of geometry.</typeparam>
internal interface IBvhLeaf<R>
    where R : unmanaged, IReal<R>
{
    /// <summary>Tests the items at places [first, first + count) of the tree's order.</summary>
    /// <param name="first">First place.</param>
    /// <param name="count">Number of items, at least 1.</param>
    /// <param name="limit">Ray parameters beyond which hits do not matter (at which they may, on ties); to be lowered. Below 0 for lanes that are off or done.</param>
    /// <returns>Whether a limit was lowered.</returns>
    bool Visit(int first, int count, ref R limit);
}
