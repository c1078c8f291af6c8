using System.Runtime.CompilerServices;
using System.Runtime.Intrinsics;
using System.Runtime.Intrinsics.X86;

namespace LabRaytracer;

/// <summary>16 floats side by side in one 512-bit register.</summary>
[method: MethodImpl(MethodImplOptions.AggressiveInlining)]
internal readonly struct Float16(Vector512<float> value) : ILane<Float16, Float16, Int16>
{
    /// <summary>The lanes as the runtime's vector.</summary>
    public readonly Vector512<float> Value = value;

    public static int Width
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => 16;
    }

    public static bool IsSingle
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => true;
    }

    public static Float16 Zero
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => new(Vector512<float>.Zero);
    }

    public static Float16 True
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => new(Vector512<float>.AllBitsSet);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Float16 operator +(Float16 a, Float16 b) => new(a.Value + b.Value);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Float16 operator -(Float16 a, Float16 b) => new(a.Value - b.Value);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Float16 operator *(Float16 a, Float16 b) => new(a.Value * b.Value);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Float16 operator /(Float16 a, Float16 b) => new(a.Value / b.Value);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Float16 operator &(Float16 a, Float16 b) => new(a.Value & b.Value);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Float16 operator |(Float16 a, Float16 b) => new(a.Value | b.Value);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Float16 operator ^(Float16 a, Float16 b) => new(a.Value ^ b.Value);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Float16 operator -(Float16 a) => new(-a.Value);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Float16 operator ~(Float16 a) => new(~a.Value);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Float16 Of(double value) => new(Vector512.Create((float)value));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Float16 Iota(double start) => new(Vector512.Create((float)start) + Vector512.Create((float)0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Float16 Abs(Float16 a) => new(Vector512.Abs(a.Value));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Float16 Min(Float16 a, Float16 b) => new(X86Base.IsSupported
        ? Vector512.MinNative(a.Value, b.Value)
        : Vector512.ConditionalSelect(Vector512.LessThan(a.Value, b.Value), a.Value, b.Value));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Float16 Max(Float16 a, Float16 b) => new(X86Base.IsSupported
        ? Vector512.MaxNative(a.Value, b.Value)
        : Vector512.ConditionalSelect(Vector512.GreaterThan(a.Value, b.Value), a.Value, b.Value));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Float16 Sqrt(Float16 a) => new(Vector512.Sqrt(a.Value));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Float16 Floor(Float16 a) => new(Vector512.Floor(a.Value));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Float16 Fma(Float16 a, Float16 b, Float16 c) => new(Vector512.FusedMultiplyAdd(a.Value, b.Value, c.Value));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Float16 Exponent(Float16 a) => new(
        (Vector512.ShiftRightLogical(a.Value.AsInt32(), 23) | Vector512.Create(LaneBits.Single23)).AsSingle() - Vector512.Create(LaneBits.Single23Bias));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Float16 PowerOfTwo(Float16 n) => new(Vector512.ShiftLeft((n.Value + Vector512.Create(LaneBits.Single23Bias)).AsInt32(), 23).AsSingle());

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Float16 Less(Float16 a, Float16 b) => new(Vector512.LessThan(a.Value, b.Value));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Float16 LessOrEqual(Float16 a, Float16 b) => new(Vector512.LessThanOrEqual(a.Value, b.Value));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Float16 Equal(Float16 a, Float16 b) => new(Vector512.Equals(a.Value, b.Value));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Float16 Select(Float16 mask, Float16 yes, Float16 no) => new(Vector512.ConditionalSelect(mask.Value, yes.Value, no.Value));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static uint Bits(Float16 mask) => (uint)mask.Value.ExtractMostSignificantBits();

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool Any(Float16 mask) => mask.Value.AsInt32() != Vector512<int>.Zero;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool All(Float16 mask) => mask.Value.AsInt32() == Vector512<int>.AllBitsSet;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static double Largest(Float16 a) => Float8.Largest(new(Vector256.MaxNative(a.Value.GetLower(), a.Value.GetUpper())));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static double Get(Float16 a, int lane) => a.Value.GetElement(lane);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Float16 ToSingle(Float16 a) => a;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Float16 FromSingle(Float16 a) => a;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Int16 ToInt32(Float16 a) => new(Vector512.ConvertToInt32Native(a.Value));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Float16 FromInt32(Int16 a) => new(Vector512.ConvertToSingle(a.Value));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Float16 MaskToSingle(Float16 mask) => mask;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Float16 MaskFromSingle(Float16 mask) => mask;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Int16 MaskToInt32(Float16 mask) => new(mask.Value.AsInt32());

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Float16 MaskFromInt32(Int16 mask) => new(mask.Value.AsSingle());

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static unsafe Float16 Gather(Float16* column, Int16 index)
    {
        if (Avx2.IsSupported)
        {
            return new(LaneHalves.Join(
                Avx2.GatherVector256((float*)column, index.Value.GetLower(), sizeof(float)),
                Avx2.GatherVector256((float*)column, index.Value.GetUpper(), sizeof(float))));
        }

        Vector512<float> gathered = default;
        for (int lane = 0; lane < 16; lane++)
        {
            Unsafe.Add(ref Unsafe.As<Vector512<float>, float>(ref gathered), lane) = ((float*)column)[index.Value.GetElement(lane)];
        }

        return new(gathered);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static unsafe Float16 Broadcast(Float16* column, int element) => new(Vector512.Create(((float*)column)[element]));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static unsafe void Put(Float16* column, int element, double value) => ((float*)column)[element] = (float)value;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static unsafe double Take(Float16* column, int element) => ((float*)column)[element];
}
