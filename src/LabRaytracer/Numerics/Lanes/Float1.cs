using System.Runtime.CompilerServices;
using System.Runtime.Intrinsics;
using System.Runtime.Intrinsics.X86;

namespace LabRaytracer;

/// <summary>One float as a lane type: the width of a student's call, and of processors without vectors.</summary>
[method: MethodImpl(MethodImplOptions.AggressiveInlining)]
internal readonly struct Float1(float value) : ILane<Float1, Float1, Int1>
{
    /// <summary>The number.</summary>
    public readonly float Value = value;

    public static int Width
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => 1;
    }

    public static bool IsSingle
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => true;
    }

    public static Float1 Zero
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => default;
    }

    public static Float1 True
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => new(BitConverter.Int32BitsToSingle(-1));
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Float1 operator +(Float1 a, Float1 b) => new(a.Value + b.Value);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Float1 operator -(Float1 a, Float1 b) => new(a.Value - b.Value);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Float1 operator *(Float1 a, Float1 b) => new(a.Value * b.Value);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Float1 operator /(Float1 a, Float1 b) => new(a.Value / b.Value);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Float1 operator &(Float1 a, Float1 b) => new((Wide(a) & Wide(b)).ToScalar());

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Float1 operator |(Float1 a, Float1 b) => new((Wide(a) | Wide(b)).ToScalar());

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Float1 operator ^(Float1 a, Float1 b) => new((Wide(a) ^ Wide(b)).ToScalar());

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Float1 operator -(Float1 a) => new(-a.Value);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Float1 operator ~(Float1 a) => new((~Wide(a)).ToScalar());

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Float1 Of(double value) => new((float)value);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Float1 Iota(double start) => new((float)start);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Float1 Abs(Float1 a) => new(MathF.Abs(a.Value));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Float1 Min(Float1 a, Float1 b) => new(X86Base.IsSupported
        ? float.MinNative(a.Value, b.Value)
        : a.Value < b.Value ? a.Value : b.Value);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Float1 Max(Float1 a, Float1 b) => new(X86Base.IsSupported
        ? float.MaxNative(a.Value, b.Value)
        : a.Value > b.Value ? a.Value : b.Value);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Float1 Sqrt(Float1 a) => new(MathF.Sqrt(a.Value));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Float1 Floor(Float1 a) => new(MathF.Floor(a.Value));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Float1 Fma(Float1 a, Float1 b, Float1 c) => new(MathF.FusedMultiplyAdd(a.Value, b.Value, c.Value));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Float1 Exponent(Float1 a) =>
        new((float)(BitConverter.SingleToInt32Bits(a.Value) >>> 23) - 127);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Float1 PowerOfTwo(Float1 n) => new(BitConverter.Int32BitsToSingle(((int)n.Value + 127) << 23));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Float1 Less(Float1 a, Float1 b) => new(Vector128.LessThan(Wide(a), Wide(b)).ToScalar());

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Float1 LessOrEqual(Float1 a, Float1 b) => new(Vector128.LessThanOrEqual(Wide(a), Wide(b)).ToScalar());

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Float1 Equal(Float1 a, Float1 b) => new(Vector128.Equals(Wide(a), Wide(b)).ToScalar());

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Float1 Select(Float1 mask, Float1 yes, Float1 no) =>
        new(Vector128.ConditionalSelect(Wide(mask), Wide(yes), Wide(no)).ToScalar());

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static uint Bits(Float1 mask) => (uint)(BitConverter.SingleToInt32Bits(mask.Value) & 1);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool Any(Float1 mask) => BitConverter.SingleToInt32Bits(mask.Value) != 0;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool All(Float1 mask) => BitConverter.SingleToInt32Bits(mask.Value) != 0;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static double Largest(Float1 a) => a.Value;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static double Get(Float1 a, int lane) => a.Value;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Float1 ToSingle(Float1 a) => a;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Float1 FromSingle(Float1 a) => a;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Float1 MaskToSingle(Float1 mask) => mask;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Float1 MaskFromSingle(Float1 mask) => mask;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Int1 MaskToInt32(Float1 mask) => new(BitConverter.SingleToInt32Bits(mask.Value));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Float1 MaskFromInt32(Int1 mask) => new(BitConverter.Int32BitsToSingle(mask.Value));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Int1 ToInt32(Float1 a) => new((int)a.Value);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Float1 FromInt32(Int1 a) => new(a.Value);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static unsafe Float1 Gather(Float1* column, Int1 index) => column[index.Value];

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static unsafe Float1 Broadcast(Float1* column, int element) => column[element];

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static unsafe void Put(Float1* column, int element, double value) => ((float*)column)[element] = (float)value;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static unsafe double Take(Float1* column, int element) => ((float*)column)[element];

    /// <summary>The number in the lowest lane of a vector register: selections then need no detour through integer registers.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Vector128<float> Wide(Float1 a) => Vector128.CreateScalarUnsafe(a.Value);
}
