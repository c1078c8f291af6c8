using System.Runtime.CompilerServices;
using System.Runtime.Intrinsics;
using System.Runtime.Intrinsics.X86;

namespace LabRaytracer;

/// <summary>One double as a lane type: the width of a student's call, and of processors without vectors.</summary>
[method: MethodImpl(MethodImplOptions.AggressiveInlining)]
internal readonly struct Double1(double value) : ILane<Double1, Float1, Int1>
{
    /// <summary>The number.</summary>
    public readonly double Value = value;

    public static int Width
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => 1;
    }

    public static bool IsSingle
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => false;
    }

    public static Double1 Zero
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => default;
    }

    public static Double1 True
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => new(BitConverter.Int64BitsToDouble(-1));
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Double1 operator +(Double1 a, Double1 b) => new(a.Value + b.Value);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Double1 operator -(Double1 a, Double1 b) => new(a.Value - b.Value);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Double1 operator *(Double1 a, Double1 b) => new(a.Value * b.Value);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Double1 operator /(Double1 a, Double1 b) => new(a.Value / b.Value);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Double1 operator &(Double1 a, Double1 b) => new((Wide(a) & Wide(b)).ToScalar());

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Double1 operator |(Double1 a, Double1 b) => new((Wide(a) | Wide(b)).ToScalar());

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Double1 operator ^(Double1 a, Double1 b) => new((Wide(a) ^ Wide(b)).ToScalar());

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Double1 operator -(Double1 a) => new(-a.Value);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Double1 operator ~(Double1 a) => new((~Wide(a)).ToScalar());

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Double1 Of(double value) => new(value);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Double1 Iota(double start) => new(start);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Double1 Abs(Double1 a) => new(Math.Abs(a.Value));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Double1 Min(Double1 a, Double1 b) => new(X86Base.IsSupported
        ? double.MinNative(a.Value, b.Value)
        : a.Value < b.Value ? a.Value : b.Value);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Double1 Max(Double1 a, Double1 b) => new(X86Base.IsSupported
        ? double.MaxNative(a.Value, b.Value)
        : a.Value > b.Value ? a.Value : b.Value);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Double1 Sqrt(Double1 a) => new(Math.Sqrt(a.Value));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Double1 Floor(Double1 a) => new(Math.Floor(a.Value));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Double1 Fma(Double1 a, Double1 b, Double1 c) => new(Math.FusedMultiplyAdd(a.Value, b.Value, c.Value));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Double1 Exponent(Double1 a) =>
        new((double)(BitConverter.DoubleToInt64Bits(a.Value) >>> 52) - 1023);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Double1 PowerOfTwo(Double1 n) => new(BitConverter.Int64BitsToDouble(((long)n.Value + 1023) << 52));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Double1 Less(Double1 a, Double1 b) => new(Vector128.LessThan(Wide(a), Wide(b)).ToScalar());

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Double1 LessOrEqual(Double1 a, Double1 b) => new(Vector128.LessThanOrEqual(Wide(a), Wide(b)).ToScalar());

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Double1 Equal(Double1 a, Double1 b) => new(Vector128.Equals(Wide(a), Wide(b)).ToScalar());

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Double1 Select(Double1 mask, Double1 yes, Double1 no) =>
        new(Vector128.ConditionalSelect(Wide(mask), Wide(yes), Wide(no)).ToScalar());

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static uint Bits(Double1 mask) => (uint)(BitConverter.DoubleToInt64Bits(mask.Value) & 1);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool Any(Double1 mask) => BitConverter.DoubleToInt64Bits(mask.Value) != 0;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool All(Double1 mask) => BitConverter.DoubleToInt64Bits(mask.Value) != 0;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static double Largest(Double1 a) => a.Value;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static double Get(Double1 a, int lane) => a.Value;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Float1 ToSingle(Double1 a) => new((float)a.Value);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Double1 FromSingle(Float1 a) => new(a.Value);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Float1 MaskToSingle(Double1 mask) => new(BitConverter.Int32BitsToSingle((int)BitConverter.DoubleToInt64Bits(mask.Value)));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Double1 MaskFromSingle(Float1 mask) => new(BitConverter.Int64BitsToDouble(BitConverter.SingleToInt32Bits(mask.Value)));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Int1 MaskToInt32(Double1 mask) => new((int)BitConverter.DoubleToInt64Bits(mask.Value));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Double1 MaskFromInt32(Int1 mask) => new(BitConverter.Int64BitsToDouble(mask.Value));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Int1 ToInt32(Double1 a) => new((int)a.Value);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Double1 FromInt32(Int1 a) => new(a.Value);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static unsafe Double1 Gather(Double1* column, Int1 index) => column[index.Value];

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static unsafe Double1 Broadcast(Double1* column, int element) => column[element];

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static unsafe void Put(Double1* column, int element, double value) => ((double*)column)[element] = value;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static unsafe double Take(Double1* column, int element) => ((double*)column)[element];

    /// <summary>The number in the lowest lane of a vector register: selections then need no detour through integer registers.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Vector128<double> Wide(Double1 a) => Vector128.CreateScalarUnsafe(a.Value);
}
