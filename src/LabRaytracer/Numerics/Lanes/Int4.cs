using System.Runtime.CompilerServices;
using System.Runtime.Intrinsics;
using System.Runtime.Intrinsics.X86;

namespace LabRaytracer;

/// <summary>4 32-bit integers side by side.</summary>
[method: MethodImpl(MethodImplOptions.AggressiveInlining)]
internal readonly struct Int4(Vector128<int> value) : IIndexLane<Int4>
{
    /// <summary>The lanes.</summary>
    public readonly Vector128<int> Value = value;

    public static int Width
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => 4;
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Int4 operator +(Int4 a, Int4 b) => new(a.Value + b.Value);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Int4 operator -(Int4 a, Int4 b) => new(a.Value - b.Value);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Int4 operator *(Int4 a, Int4 b) => new(a.Value * b.Value);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Int4 operator &(Int4 a, Int4 b) => new(a.Value & b.Value);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Int4 operator |(Int4 a, Int4 b) => new(a.Value | b.Value);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Int4 operator ^(Int4 a, Int4 b) => new(a.Value ^ b.Value);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Int4 operator ~(Int4 a) => new(~a.Value);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Int4 Of(int value) => new(Vector128.Create(value));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Int4 Iota(int start) => new(Vector128.Create(start) + Vector128.Create(0, 1, 2, 3));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Int4 Min(Int4 a, Int4 b) => new(Vector128.Min(a.Value, b.Value));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Int4 Max(Int4 a, Int4 b) => new(Vector128.Max(a.Value, b.Value));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Int4 Less(Int4 a, Int4 b) => new(Vector128.LessThan(a.Value, b.Value));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Int4 Equal(Int4 a, Int4 b) => new(Vector128.Equals(a.Value, b.Value));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool AllEqual(Int4 a, int value) => a.Value == Vector128.Create(value);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Int4 Select(Int4 mask, Int4 yes, Int4 no) => new(Vector128.ConditionalSelect(mask.Value, yes.Value, no.Value));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Int4 ShiftRight(Int4 a, int bits) => new(Vector128.ShiftRightLogical(a.Value, bits));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static int Get(Int4 a, int lane) => a.Value.GetElement(lane);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static unsafe Int4 Gather(int* table, Int4 index)
    {
        if (Avx2.IsSupported)
        {
            return new(Avx2.GatherVector128(table, index.Value, sizeof(int)));
        }

        Vector128<int> gathered = default;
        for (int lane = 0; lane < 4; lane++)
        {
            Unsafe.Add(ref Unsafe.As<Vector128<int>, int>(ref gathered), lane) = table[index.Value.GetElement(lane)];
        }

        return new(gathered);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static unsafe void LoadPairs(int* table, Int4* index, out Int4 first, out Int4 second)
    {
        Vector128<long> low = LanePairs.Two(table, (int*)index), high = LanePairs.Two(table, (int*)index + 2);
        first = new(Vector128.Narrow(low, high));
        second = new(Vector128.Narrow(Vector128.ShiftRightLogical(low, 32), Vector128.ShiftRightLogical(high, 32)));
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static unsafe void LoadTriples(byte* table, Int4* offset, out Int4 first, out Int4 second)
    {
        Vector128<long> low = LanePairs.Two(table, (int*)offset), high = LanePairs.Two(table, (int*)offset + 2);
        first = new(Vector128.Narrow(low, high));
        second = new(Vector128.Narrow(Vector128.ShiftRightLogical(low, 24), Vector128.ShiftRightLogical(high, 24)));
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static unsafe Int4 Load(int* elements) => new(Vector128.Load(elements));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static unsafe void Store(Int4 a, int* elements) => a.Value.Store(elements);
}
