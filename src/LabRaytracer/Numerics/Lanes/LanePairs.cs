using System.Runtime.CompilerServices;
using System.Runtime.Intrinsics;

namespace LabRaytracer;

/// <summary>Neighbouring pairs of 32-bit elements, or any eight bytes, each read at once as 64 bits: plain loads, which are faster than gathers.</summary>
internal static unsafe class LanePairs
{
    /// <summary>Two pairs.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Vector128<long> Two(int* table, int* index) =>
        Vector128.CreateScalarUnsafe(*(long*)(table + index[0])).WithElement(1, *(long*)(table + index[1]));

    /// <summary>Four pairs.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Vector256<long> Four(int* table, int* index) =>
        Two(table, index).ToVector256Unsafe().WithUpper(Two(table, index + 2));

    /// <summary>Eight pairs.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Vector512<long> Eight(int* table, int* index) => LaneHalves.Join(Four(table, index), Four(table, index + 4));

    /// <summary>Eight bytes from each of two places.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Vector128<long> Two(byte* table, int* offset) =>
        Vector128.CreateScalarUnsafe(Unsafe.ReadUnaligned<long>(table + offset[0])).WithElement(1, Unsafe.ReadUnaligned<long>(table + offset[1]));

    /// <summary>Eight bytes from each of four places.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Vector256<long> Four(byte* table, int* offset) =>
        Two(table, offset).ToVector256Unsafe().WithUpper(Two(table, offset + 2));

    /// <summary>Eight bytes from each of eight places.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Vector512<long> Eight(byte* table, int* offset) => LaneHalves.Join(Four(table, offset), Four(table, offset + 4));
}
