using System.Runtime.CompilerServices;
using System.Runtime.InteropServices;

namespace LabRaytracer;

/// <summary>An item's box (<see cref="BvhReach"/>) while a tree is built; read as one group of eight floats.</summary>
[StructLayout(LayoutKind.Sequential)]
internal unsafe struct BvhReference
{
    /// <summary>
    /// Added to item numbers: they sit in the fourth float, where the bits of a small integer would be a subnormal float,
    /// which makes every vector operation on it slow.
    /// </summary>
    private const int NormalFloat = 0x3F80_0000;

    public float NegativeMinX, NegativeMinY, NegativeMinZ;
    private int _number;
    public float MaxX, MaxY, MaxZ;
    private float _unused;

    /// <summary>Number of the item, [0, 2^30).</summary>
    public readonly int Number => _number - NormalFloat;

    /// <summary>The eight floats of a reference.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Float8 ReachOf(BvhReference* reference) => *(Float8*)reference;

    /// <summary>Writes all of it.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void Set(Float8 reach, int number)
    {
        Unsafe.As<float, Float8>(ref NegativeMinX) = reach;
        _number = number + NormalFloat;
        _unused = 1;
    }
}
