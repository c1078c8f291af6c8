using System.Runtime.CompilerServices;
using System.Runtime.Intrinsics;
using System.Runtime.Intrinsics.X86;

namespace LabRaytracer;

/// <summary>8 doubles side by side in two 256-bit registers: as many lanes as one register of floats.</summary>
[method: MethodImpl(MethodImplOptions.AggressiveInlining)]
internal readonly struct Double8(Vector256<double> low, Vector256<double> high) : ILane<Double8, Float8, Int8>
{
    /// <summary>Lanes 0 to 3.</summary>
    public readonly Vector256<double> Low = low;

    /// <summary>Lanes 4 to 7.</summary>
    public readonly Vector256<double> High = high;

    public static int Width
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => 8;
    }

    public static bool IsSingle
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => false;
    }

    public static Double8 Zero
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => new(Vector256<double>.Zero, Vector256<double>.Zero);
    }

    public static Double8 True
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => new(Vector256<double>.AllBitsSet, Vector256<double>.AllBitsSet);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Double8 operator +(Double8 a, Double8 b) => new(a.Low + b.Low, a.High + b.High);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Double8 operator -(Double8 a, Double8 b) => new(a.Low - b.Low, a.High - b.High);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Double8 operator *(Double8 a, Double8 b) => new(a.Low * b.Low, a.High * b.High);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Double8 operator /(Double8 a, Double8 b) => new(a.Low / b.Low, a.High / b.High);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Double8 operator &(Double8 a, Double8 b) => new(a.Low & b.Low, a.High & b.High);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Double8 operator |(Double8 a, Double8 b) => new(a.Low | b.Low, a.High | b.High);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Double8 operator ^(Double8 a, Double8 b) => new(a.Low ^ b.Low, a.High ^ b.High);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Double8 operator -(Double8 a) => new(-a.Low, -a.High);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Double8 operator ~(Double8 a) => new(~a.Low, ~a.High);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Double8 Of(double value)
    {
        Vector256<double> same = Vector256.Create(value);
        return new(same, same);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Double8 Iota(double start) => new(
        Vector256.Create(start) + Vector256.Create((double)0, 1, 2, 3),
        Vector256.Create(start) + Vector256.Create((double)4, 5, 6, 7));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Double8 Abs(Double8 a) => new(Vector256.Abs(a.Low), Vector256.Abs(a.High));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Double8 Min(Double8 a, Double8 b) => X86Base.IsSupported
        ? new(Vector256.MinNative(a.Low, b.Low), Vector256.MinNative(a.High, b.High))
        : Select(Less(a, b), a, b);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Double8 Max(Double8 a, Double8 b) => X86Base.IsSupported
        ? new(Vector256.MaxNative(a.Low, b.Low), Vector256.MaxNative(a.High, b.High))
        : Select(Less(b, a), a, b);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Double8 Sqrt(Double8 a) => new(Vector256.Sqrt(a.Low), Vector256.Sqrt(a.High));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Double8 Floor(Double8 a) => new(Vector256.Floor(a.Low), Vector256.Floor(a.High));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Double8 Fma(Double8 a, Double8 b, Double8 c) => new(
        Vector256.FusedMultiplyAdd(a.Low, b.Low, c.Low), Vector256.FusedMultiplyAdd(a.High, b.High, c.High));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Double8 Exponent(Double8 a) => new(
        (Vector256.ShiftRightLogical(a.Low.AsInt64(), 52) | Vector256.Create(LaneBits.Double52)).AsDouble() - Vector256.Create(LaneBits.Double52Bias),
        (Vector256.ShiftRightLogical(a.High.AsInt64(), 52) | Vector256.Create(LaneBits.Double52)).AsDouble() - Vector256.Create(LaneBits.Double52Bias));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Double8 PowerOfTwo(Double8 n) => new(
        Vector256.ShiftLeft((n.Low + Vector256.Create(LaneBits.Double52Bias)).AsInt64(), 52).AsDouble(),
        Vector256.ShiftLeft((n.High + Vector256.Create(LaneBits.Double52Bias)).AsInt64(), 52).AsDouble());

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Double8 Less(Double8 a, Double8 b) => new(Vector256.LessThan(a.Low, b.Low), Vector256.LessThan(a.High, b.High));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Double8 LessOrEqual(Double8 a, Double8 b) => new(Vector256.LessThanOrEqual(a.Low, b.Low), Vector256.LessThanOrEqual(a.High, b.High));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Double8 Equal(Double8 a, Double8 b) => new(Vector256.Equals(a.Low, b.Low), Vector256.Equals(a.High, b.High));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Double8 Select(Double8 mask, Double8 yes, Double8 no) => new(
        Vector256.ConditionalSelect(mask.Low, yes.Low, no.Low), Vector256.ConditionalSelect(mask.High, yes.High, no.High));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static uint Bits(Double8 mask) =>
        mask.Low.ExtractMostSignificantBits() | (mask.High.ExtractMostSignificantBits() << 4);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool Any(Double8 mask) => (mask.Low | mask.High).AsInt64() != Vector256<long>.Zero;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool All(Double8 mask) => (mask.Low & mask.High).AsInt64() == Vector256<long>.AllBitsSet;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static double Largest(Double8 a) => Double4.Largest(new(Vector256.MaxNative(a.Low, a.High)));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static double Get(Double8 a, int lane) => lane < 4 ? a.Low.GetElement(lane) : a.High.GetElement(lane - 4);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Float8 ToSingle(Double8 a) => new(Vector256.Narrow(a.Low, a.High));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Double8 FromSingle(Float8 a)
    {
        (Vector256<double> low, Vector256<double> high) = Vector256.Widen(a.Value);
        return new(low, high);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Int8 ToInt32(Double8 a) => Avx.IsSupported
        ? new(Vector256.Create(Avx.ConvertToVector128Int32WithTruncation(a.Low), Avx.ConvertToVector128Int32WithTruncation(a.High)))
        : new(Vector256.Narrow(Vector256.ConvertToInt64Native(a.Low), Vector256.ConvertToInt64Native(a.High)));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Double8 FromInt32(Int8 a)
    {
        if (Avx.IsSupported)
        {
            return new(Avx.ConvertToVector256Double(a.Value.GetLower()), Avx.ConvertToVector256Double(a.Value.GetUpper()));
        }

        (Vector256<long> low, Vector256<long> high) = Vector256.Widen(a.Value);
        return new(Vector256.ConvertToDouble(low), Vector256.ConvertToDouble(high));
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Float8 MaskToSingle(Double8 mask) => new(Vector256.Narrow(mask.Low.AsInt64(), mask.High.AsInt64()).AsSingle());

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Double8 MaskFromSingle(Float8 mask)
    {
        (Vector256<long> low, Vector256<long> high) = Vector256.Widen(mask.Value.AsInt32());
        return new(low.AsDouble(), high.AsDouble());
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Int8 MaskToInt32(Double8 mask) => new(MaskToSingle(mask).Value.AsInt32());

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Double8 MaskFromInt32(Int8 mask) => MaskFromSingle(new Float8(mask.Value.AsSingle()));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static unsafe Double8 Gather(Double8* column, Int8 index)
    {
        if (Avx2.IsSupported)
        {
            return new(
                Avx2.GatherVector256((double*)column, index.Value.GetLower(), sizeof(double)),
                Avx2.GatherVector256((double*)column, index.Value.GetUpper(), sizeof(double)));
        }

        Double8 gathered = default;
        for (int lane = 0; lane < 8; lane++)
        {
            Unsafe.Add(ref Unsafe.As<Double8, double>(ref gathered), lane) = ((double*)column)[index.Value.GetElement(lane)];
        }

        return gathered;
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static unsafe Double8 Broadcast(Double8* column, int element) => Of(((double*)column)[element]);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static unsafe void Put(Double8* column, int element, double value) => ((double*)column)[element] = value;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static unsafe double Take(Double8* column, int element) => ((double*)column)[element];
}
