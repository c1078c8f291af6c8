using System.Runtime.CompilerServices;

namespace LabRaytracer;

/// <summary>A box while a tree is built (<see cref="BvhReach"/>); the fourth and eighth lanes are unused.</summary>
internal struct BvhBox
{
    public Float8 Reach;

    /// <summary>The box that contains nothing.</summary>
    public static BvhBox Empty
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => new() { Reach = Float8.Of(float.MinValue) };
    }

    /// <summary>Half the area of the box's surface.</summary>
    public readonly float HalfArea
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => Float4.SumOfPairs(Float8.Upper(Reach) + Float8.Lower(Reach));
    }

    /// <summary>Grows to contain another box.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void Include(Float8 reach) => Reach = Float8.Max(Reach, reach);
}
