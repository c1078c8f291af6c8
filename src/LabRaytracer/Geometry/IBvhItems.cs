namespace LabRaytracer;

/// <summary>The things that a tree of boxes sorts.</summary>
internal interface IBvhItems
{
    /// <summary>How many there are.</summary>
    int Count { get; }

    /// <summary>The box of one item; finite.</summary>
    Bounds BoundsOf(int item);
}
