using System.Runtime.CompilerServices;

namespace LabRaytracer;

/// <summary>Items [First, First + Count) on their way into a node.</summary>
internal unsafe struct BvhRange
{
    public int First, Count;

    /// <summary>The box of the items.</summary>
    public BvhBox Box;

    /// <summary>The box of the sums min + max of the items' boxes: twice their centres.</summary>
    public Float4 MinCenter, MaxCenter;

    public static BvhRange Empty(int first) => new()
    {
        First = first, Box = BvhBox.Empty, MinCenter = Float4.Of(float.MaxValue), MaxCenter = Float4.Of(float.MinValue),
    };

    /// <summary>Twice the centre of an item.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Float4 CenterOf(Float8 reach) => Float8.Upper(reach) - Float8.Lower(reach);

    /// <summary>Adds an item.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void Append(BvhReference* reference)
    {
        Float8 reach = BvhReference.ReachOf(reference);
        Float4 center = CenterOf(reach);
        Box.Include(reach);
        MinCenter = Float4.Min(MinCenter, center);
        MaxCenter = Float4.Max(MaxCenter, center);
        Count++;
    }

    /// <summary>Adds the items of another range, which follow.</summary>
    public void Append(in BvhRange other)
    {
        Box.Include(other.Box.Reach);
        MinCenter = Float4.Min(MinCenter, other.MinCenter);
        MaxCenter = Float4.Max(MaxCenter, other.MaxCenter);
        Count += other.Count;
    }
}
