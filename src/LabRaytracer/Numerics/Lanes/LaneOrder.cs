using System.Runtime.CompilerServices;
using System.Runtime.Intrinsics;
using System.Runtime.Intrinsics.X86;

namespace LabRaytracer;

/// <summary>Lanes in another order.</summary>
internal static class LaneOrder
{
    /// <summary>Sorts lanes, the largest first, without branches.</summary>
    /// <remarks>Source: Batcher, "Sorting networks and their applications", AFIPS Spring Joint Computer Conference, 1968 (bitonic sorter).</remarks>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Int8 Descending(Int8 lanes)
    {
        Vector256<int> a = lanes.Value;
        a = Exchange(a, Vector256.Shuffle(a, Vector256.Create(1, 0, 3, 2, 5, 4, 7, 6)), Vector256.Create(0, -1, 0, -1, 0, -1, 0, -1));
        a = Exchange(a, Vector256.Shuffle(a, Vector256.Create(3, 2, 1, 0, 7, 6, 5, 4)), Vector256.Create(0, 0, -1, -1, 0, 0, -1, -1));
        a = Exchange(a, Vector256.Shuffle(a, Vector256.Create(1, 0, 3, 2, 5, 4, 7, 6)), Vector256.Create(0, -1, 0, -1, 0, -1, 0, -1));
        a = Exchange(a, Vector256.Shuffle(a, Vector256.Create(7, 6, 5, 4, 3, 2, 1, 0)), Vector256.Create(0, 0, 0, 0, -1, -1, -1, -1));
        a = Exchange(a, Vector256.Shuffle(a, Vector256.Create(2, 3, 0, 1, 6, 7, 4, 5)), Vector256.Create(0, 0, -1, -1, 0, 0, -1, -1));
        a = Exchange(a, Vector256.Shuffle(a, Vector256.Create(1, 0, 3, 2, 5, 4, 7, 6)), Vector256.Create(0, -1, 0, -1, 0, -1, 0, -1));
        return new(a);
    }

    /// <summary>The lanes at given places, of which the lowest three bits count.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Int8 At(Int8 lanes, Int8 places) => new(Avx2.IsSupported
        ? Avx2.PermuteVar8x32(lanes.Value, places.Value)
        : Vector256.Shuffle(lanes.Value, places.Value & Vector256.Create(7)));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Vector256<int> Exchange(Vector256<int> a, Vector256<int> b, Vector256<int> isLess) =>
        Vector256.ConditionalSelect(isLess, Vector256.Min(a, b), Vector256.Max(a, b));
}
