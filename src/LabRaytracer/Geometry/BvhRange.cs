namespace LabRaytracer;

/// <summary>Items [First, First + Count) on their way into a node.</summary>
internal struct BvhRange
{
    public int First, Count;

    /// <summary>The box of the items.</summary>
    public BvhBox Box;

    /// <summary>The box of the sums min + max of the items' boxes: twice their centres.</summary>
    public BvhBox Centers;

    public static BvhRange Empty(int first) => new() { First = first, Box = BvhBox.Empty, Centers = BvhBox.Empty };
}
