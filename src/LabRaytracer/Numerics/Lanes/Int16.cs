using System.Runtime.CompilerServices;
using System.Runtime.Intrinsics;
using System.Runtime.Intrinsics.X86;

namespace LabRaytracer;

/// <summary>16 32-bit integers side by side.</summary>
[method: MethodImpl(MethodImplOptions.AggressiveInlining)]
internal readonly struct Int16(Vector512<int> value) : IIndexLane<Int16>
{
    /// <summary>The lanes.</summary>
    public readonly Vector512<int> Value = value;

    public static int Width
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => 16;
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Int16 operator +(Int16 a, Int16 b) => new(a.Value + b.Value);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Int16 operator -(Int16 a, Int16 b) => new(a.Value - b.Value);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Int16 operator *(Int16 a, Int16 b) => new(a.Value * b.Value);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Int16 operator &(Int16 a, Int16 b) => new(a.Value & b.Value);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Int16 operator |(Int16 a, Int16 b) => new(a.Value | b.Value);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Int16 operator ^(Int16 a, Int16 b) => new(a.Value ^ b.Value);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Int16 operator ~(Int16 a) => new(~a.Value);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Int16 Of(int value) => new(Vector512.Create(value));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Int16 Iota(int start) => new(Vector512.Create(start) + Vector512.Create(0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Int16 Min(Int16 a, Int16 b) => new(Vector512.Min(a.Value, b.Value));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Int16 Max(Int16 a, Int16 b) => new(Vector512.Max(a.Value, b.Value));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Int16 Less(Int16 a, Int16 b) => new(Vector512.LessThan(a.Value, b.Value));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Int16 Equal(Int16 a, Int16 b) => new(Vector512.Equals(a.Value, b.Value));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool AllEqual(Int16 a, int value) => a.Value == Vector512.Create(value);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Int16 Select(Int16 mask, Int16 yes, Int16 no) => new(Vector512.ConditionalSelect(mask.Value, yes.Value, no.Value));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Int16 ShiftRight(Int16 a, int bits) => new(Vector512.ShiftRightLogical(a.Value, bits));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static int Get(Int16 a, int lane) => a.Value.GetElement(lane);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static unsafe Int16 Gather(int* table, Int16 index)
    {
        if (Avx2.IsSupported)
        {
            return new(LaneHalves.Join(
                Avx2.GatherVector256(table, index.Value.GetLower(), sizeof(int)),
                Avx2.GatherVector256(table, index.Value.GetUpper(), sizeof(int))));
        }

        Vector512<int> gathered = default;
        for (int lane = 0; lane < 16; lane++)
        {
            Unsafe.Add(ref Unsafe.As<Vector512<int>, int>(ref gathered), lane) = table[index.Value.GetElement(lane)];
        }

        return new(gathered);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static unsafe void LoadPairs(int* table, Int16* index, out Int16 first, out Int16 second)
    {
        Vector512<long> low = LanePairs.Eight(table, (int*)index), high = LanePairs.Eight(table, (int*)index + 8);
        if (Avx512F.IsSupported)
        {
            Vector512<int> even = Vector512.Create(0, 2, 4, 6, 8, 10, 12, 14, 16, 18, 20, 22, 24, 26, 28, 30);
            first = new(Avx512F.PermuteVar16x32x2(low.AsInt32(), even, high.AsInt32()));
            second = new(Avx512F.PermuteVar16x32x2(low.AsInt32(), even + Vector512<int>.One, high.AsInt32()));
            return;
        }

        first = new(Vector512.Narrow(low, high));
        second = new(Vector512.Narrow(Vector512.ShiftRightLogical(low, 32), Vector512.ShiftRightLogical(high, 32)));
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static unsafe void LoadTriples(byte* table, Int16* offset, out Int16 first, out Int16 second)
    {
        Vector512<long> low = LanePairs.Eight(table, (int*)offset), high = LanePairs.Eight(table, (int*)offset + 8);
        Vector512<long> low3 = Vector512.ShiftRightLogical(low, 24), high3 = Vector512.ShiftRightLogical(high, 24);
        if (Avx512F.IsSupported)
        {
            Vector512<int> even = Vector512.Create(0, 2, 4, 6, 8, 10, 12, 14, 16, 18, 20, 22, 24, 26, 28, 30);
            first = new(Avx512F.PermuteVar16x32x2(low.AsInt32(), even, high.AsInt32()));
            second = new(Avx512F.PermuteVar16x32x2(low3.AsInt32(), even, high3.AsInt32()));
            return;
        }

        first = new(Vector512.Narrow(low, high));
        second = new(Vector512.Narrow(low3, high3));
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static unsafe Int16 Load(int* elements) => new(Vector512.Load(elements));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static unsafe void Store(Int16 a, int* elements) => a.Value.Store(elements);
}
