using System.Runtime.CompilerServices;
using System.Runtime.Intrinsics;
using System.Runtime.Intrinsics.X86;

namespace LabRaytracer;

/// <summary>2 doubles side by side in one 128-bit register: the two angles of one point, evaluated together.</summary>
[method: MethodImpl(MethodImplOptions.AggressiveInlining)]
internal readonly struct Double2(Vector128<double> value) : IReal<Double2>
{
    /// <summary>The lanes as the runtime's vector.</summary>
    public readonly Vector128<double> Value = value;

    public static int Width
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => 2;
    }

    public static bool IsSingle
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => false;
    }

    public static Double2 Zero
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => new(Vector128<double>.Zero);
    }

    public static Double2 True
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => new(Vector128<double>.AllBitsSet);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Double2 operator +(Double2 a, Double2 b) => new(a.Value + b.Value);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Double2 operator -(Double2 a, Double2 b) => new(a.Value - b.Value);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Double2 operator *(Double2 a, Double2 b) => new(a.Value * b.Value);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Double2 operator /(Double2 a, Double2 b) => new(a.Value / b.Value);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Double2 operator &(Double2 a, Double2 b) => new(a.Value & b.Value);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Double2 operator |(Double2 a, Double2 b) => new(a.Value | b.Value);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Double2 operator ^(Double2 a, Double2 b) => new(a.Value ^ b.Value);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Double2 operator -(Double2 a) => new(-a.Value);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Double2 operator ~(Double2 a) => new(~a.Value);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Double2 Of(double value) => new(Vector128.Create(value));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Double2 Iota(double start) => new(Vector128.Create(start) + Vector128.Create((double)0, 1));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Double2 Abs(Double2 a) => new(Vector128.Abs(a.Value));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Double2 Min(Double2 a, Double2 b) => new(X86Base.IsSupported
        ? Vector128.MinNative(a.Value, b.Value)
        : Vector128.ConditionalSelect(Vector128.LessThan(a.Value, b.Value), a.Value, b.Value));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Double2 Max(Double2 a, Double2 b) => new(X86Base.IsSupported
        ? Vector128.MaxNative(a.Value, b.Value)
        : Vector128.ConditionalSelect(Vector128.GreaterThan(a.Value, b.Value), a.Value, b.Value));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Double2 Sqrt(Double2 a) => new(Vector128.Sqrt(a.Value));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Double2 Floor(Double2 a) => new(Vector128.Floor(a.Value));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Double2 Fma(Double2 a, Double2 b, Double2 c) => new(Vector128.FusedMultiplyAdd(a.Value, b.Value, c.Value));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Double2 Exponent(Double2 a) => new(
        (Vector128.ShiftRightLogical(a.Value.AsInt64(), 52) | Vector128.Create(LaneBits.Double52)).AsDouble() - Vector128.Create(LaneBits.Double52Bias));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Double2 PowerOfTwo(Double2 n) => new(Vector128.ShiftLeft((n.Value + Vector128.Create(LaneBits.Double52Bias)).AsInt64(), 52).AsDouble());

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Double2 Less(Double2 a, Double2 b) => new(Vector128.LessThan(a.Value, b.Value));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Double2 LessOrEqual(Double2 a, Double2 b) => new(Vector128.LessThanOrEqual(a.Value, b.Value));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Double2 Equal(Double2 a, Double2 b) => new(Vector128.Equals(a.Value, b.Value));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Double2 Select(Double2 mask, Double2 yes, Double2 no) => new(Vector128.ConditionalSelect(mask.Value, yes.Value, no.Value));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static uint Bits(Double2 mask) => mask.Value.ExtractMostSignificantBits();

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool Any(Double2 mask) => mask.Value.AsInt64() != Vector128<long>.Zero;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool All(Double2 mask) => mask.Value.AsInt64() == Vector128<long>.AllBitsSet;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static double Largest(Double2 a) => double.MaxNative(a.Value.ToScalar(), a.Value.GetElement(1));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static double Get(Double2 a, int lane) => a.Value.GetElement(lane);

    /// <summary>Two numbers side by side.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Double2 Pair(Double1 first, Double1 second) => new(Vector128.Create(first.Value, second.Value));
}
