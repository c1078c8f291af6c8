using System.Runtime.CompilerServices;
using System.Runtime.Intrinsics;
using System.Runtime.Intrinsics.X86;

namespace LabRaytracer;

/// <summary>8 32-bit integers side by side.</summary>
[method: MethodImpl(MethodImplOptions.AggressiveInlining)]
internal readonly struct Int8(Vector256<int> value) : IIndexLane<Int8>
{
    /// <summary>The lanes.</summary>
    public readonly Vector256<int> Value = value;

    public static int Width
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => 8;
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Int8 operator +(Int8 a, Int8 b) => new(a.Value + b.Value);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Int8 operator -(Int8 a, Int8 b) => new(a.Value - b.Value);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Int8 operator *(Int8 a, Int8 b) => new(a.Value * b.Value);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Int8 operator &(Int8 a, Int8 b) => new(a.Value & b.Value);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Int8 operator |(Int8 a, Int8 b) => new(a.Value | b.Value);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Int8 operator ^(Int8 a, Int8 b) => new(a.Value ^ b.Value);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Int8 operator ~(Int8 a) => new(~a.Value);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Int8 Of(int value) => new(Vector256.Create(value));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Int8 Iota(int start) => new(Vector256.Create(start) + Vector256.Create(0, 1, 2, 3, 4, 5, 6, 7));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Int8 Min(Int8 a, Int8 b) => new(Vector256.Min(a.Value, b.Value));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Int8 Max(Int8 a, Int8 b) => new(Vector256.Max(a.Value, b.Value));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Int8 Less(Int8 a, Int8 b) => new(Vector256.LessThan(a.Value, b.Value));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Int8 Equal(Int8 a, Int8 b) => new(Vector256.Equals(a.Value, b.Value));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool AllEqual(Int8 a, int value) => a.Value == Vector256.Create(value);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Int8 Select(Int8 mask, Int8 yes, Int8 no) => new(Vector256.ConditionalSelect(mask.Value, yes.Value, no.Value));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Int8 ShiftRight(Int8 a, int bits) => new(Vector256.ShiftRightLogical(a.Value, bits));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static int Get(Int8 a, int lane) => a.Value.GetElement(lane);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static unsafe Int8 Gather(int* table, Int8 index)
    {
        if (Avx2.IsSupported)
        {
            return new(Avx2.GatherVector256(table, index.Value, sizeof(int)));
        }

        Vector256<int> gathered = default;
        for (int lane = 0; lane < 8; lane++)
        {
            Unsafe.Add(ref Unsafe.As<Vector256<int>, int>(ref gathered), lane) = table[index.Value.GetElement(lane)];
        }

        return new(gathered);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static unsafe void LoadPairs(int* table, Int8* index, out Int8 first, out Int8 second)
    {
        Vector256<long> low = LanePairs.Four(table, (int*)index), high = LanePairs.Four(table, (int*)index + 4);
        first = new(Vector256.Narrow(low, high));
        second = new(Vector256.Narrow(Vector256.ShiftRightLogical(low, 32), Vector256.ShiftRightLogical(high, 32)));
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static unsafe void LoadTriples(byte* table, Int8* offset, out Int8 first, out Int8 second)
    {
        Vector256<long> low = LanePairs.Four(table, (int*)offset), high = LanePairs.Four(table, (int*)offset + 4);
        first = new(Vector256.Narrow(low, high));
        second = new(Vector256.Narrow(Vector256.ShiftRightLogical(low, 24), Vector256.ShiftRightLogical(high, 24)));
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static unsafe Int8 Load(int* elements) => new(Vector256.Load(elements));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static unsafe void Store(Int8 a, int* elements) => a.Value.Store(elements);
}
