using System.Runtime.CompilerServices;

namespace LabRaytracer;

/// <summary>A box in floats while a tree is built; the fourth lane is unused.</summary>
internal struct BvhBox
{
    public Float4 Min, Max;

    /// <summary>The box that contains nothing.</summary>
    public static BvhBox Empty => new() { Min = Float4.Of(float.MaxValue), Max = Float4.Of(float.MinValue) };

    /// <summary>Half the area of the box's surface.</summary>
    public readonly float HalfArea
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get
        {
            Float4 size = Max - Min;
            float x = (float)Float4.Get(size, 0), y = (float)Float4.Get(size, 1), z = (float)Float4.Get(size, 2);
            return (x * y) + (y * z) + (z * x);
        }
    }

    /// <summary>Grows to contain another box.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void Include(Float4 min, Float4 max)
    {
        Min = Float4.Min(Min, min);
        Max = Float4.Max(Max, max);
    }
}
