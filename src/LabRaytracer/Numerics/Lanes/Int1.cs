using System.Runtime.CompilerServices;

namespace LabRaytracer;

/// <summary>1 32-bit integer as a lane type.</summary>
[method: MethodImpl(MethodImplOptions.AggressiveInlining)]
internal readonly struct Int1(int value) : IIndexLane<Int1>
{
    /// <summary>The lanes.</summary>
    public readonly int Value = value;

    public static int Width
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => 1;
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Int1 operator +(Int1 a, Int1 b) => new(a.Value + b.Value);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Int1 operator -(Int1 a, Int1 b) => new(a.Value - b.Value);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Int1 operator *(Int1 a, Int1 b) => new(a.Value * b.Value);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Int1 operator &(Int1 a, Int1 b) => new(a.Value & b.Value);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Int1 operator |(Int1 a, Int1 b) => new(a.Value | b.Value);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Int1 operator ^(Int1 a, Int1 b) => new(a.Value ^ b.Value);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Int1 operator ~(Int1 a) => new(~a.Value);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Int1 Of(int value) => new(value);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Int1 Iota(int start) => new(start);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Int1 Min(Int1 a, Int1 b) => new(Math.Min(a.Value, b.Value));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Int1 Max(Int1 a, Int1 b) => new(Math.Max(a.Value, b.Value));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Int1 Less(Int1 a, Int1 b) => new(a.Value < b.Value ? -1 : 0);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Int1 Equal(Int1 a, Int1 b) => new(a.Value == b.Value ? -1 : 0);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool AllEqual(Int1 a, int value) => a.Value == value;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Int1 Select(Int1 mask, Int1 yes, Int1 no) => new((mask.Value & yes.Value) | (~mask.Value & no.Value));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Int1 ShiftRight(Int1 a, int bits) => new(a.Value >>> bits);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static int Get(Int1 a, int lane) => a.Value;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static unsafe Int1 Gather(int* table, Int1 index) => new(table[index.Value]);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static unsafe void LoadPairs(int* table, Int1* index, out Int1 first, out Int1 second)
    {
        int* pair = table + index->Value;
        first = new(pair[0]);
        second = new(pair[1]);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static unsafe void LoadTriples(byte* table, Int1* offset, out Int1 first, out Int1 second)
    {
        first = new(Unsafe.ReadUnaligned<int>(table + offset->Value));
        second = new(Unsafe.ReadUnaligned<int>(table + offset->Value + 3));
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static unsafe Int1 Load(int* elements) => new(*elements);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static unsafe void Store(Int1 a, int* elements) => *elements = a.Value;
}
