using System.Runtime.CompilerServices;
using System.Runtime.Intrinsics;
using System.Runtime.Intrinsics.X86;

namespace LabRaytracer;

/// <summary>16 doubles side by side in two 512-bit registers: as many lanes as one register of floats.</summary>
[method: MethodImpl(MethodImplOptions.AggressiveInlining)]
internal readonly struct Double16(Vector512<double> low, Vector512<double> high) : ILane<Double16, Float16, Int16>
{
    /// <summary>Lanes 0 to 7.</summary>
    public readonly Vector512<double> Low = low;

    /// <summary>Lanes 8 to 15.</summary>
    public readonly Vector512<double> High = high;

    public static int Width
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => 16;
    }

    public static bool IsSingle
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => false;
    }

    public static Double16 Zero
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => new(Vector512<double>.Zero, Vector512<double>.Zero);
    }

    public static Double16 True
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => new(Vector512<double>.AllBitsSet, Vector512<double>.AllBitsSet);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Double16 operator +(Double16 a, Double16 b) => new(a.Low + b.Low, a.High + b.High);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Double16 operator -(Double16 a, Double16 b) => new(a.Low - b.Low, a.High - b.High);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Double16 operator *(Double16 a, Double16 b) => new(a.Low * b.Low, a.High * b.High);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Double16 operator /(Double16 a, Double16 b) => new(a.Low / b.Low, a.High / b.High);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Double16 operator &(Double16 a, Double16 b) => new(a.Low & b.Low, a.High & b.High);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Double16 operator |(Double16 a, Double16 b) => new(a.Low | b.Low, a.High | b.High);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Double16 operator ^(Double16 a, Double16 b) => new(a.Low ^ b.Low, a.High ^ b.High);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Double16 operator -(Double16 a) => new(-a.Low, -a.High);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Double16 operator ~(Double16 a) => new(~a.Low, ~a.High);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Double16 Of(double value)
    {
        Vector512<double> same = Vector512.Create(value);
        return new(same, same);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Double16 Iota(double start) => new(
        Vector512.Create(start) + Vector512.Create((double)0, 1, 2, 3, 4, 5, 6, 7),
        Vector512.Create(start) + Vector512.Create((double)8, 9, 10, 11, 12, 13, 14, 15));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Double16 Abs(Double16 a) => new(Vector512.Abs(a.Low), Vector512.Abs(a.High));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Double16 Min(Double16 a, Double16 b) => X86Base.IsSupported
        ? new(Vector512.MinNative(a.Low, b.Low), Vector512.MinNative(a.High, b.High))
        : Select(Less(a, b), a, b);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Double16 Max(Double16 a, Double16 b) => X86Base.IsSupported
        ? new(Vector512.MaxNative(a.Low, b.Low), Vector512.MaxNative(a.High, b.High))
        : Select(Less(b, a), a, b);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Double16 Sqrt(Double16 a) => new(Vector512.Sqrt(a.Low), Vector512.Sqrt(a.High));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Double16 Floor(Double16 a) => new(Vector512.Floor(a.Low), Vector512.Floor(a.High));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Double16 Fma(Double16 a, Double16 b, Double16 c) => new(
        Vector512.FusedMultiplyAdd(a.Low, b.Low, c.Low), Vector512.FusedMultiplyAdd(a.High, b.High, c.High));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Double16 Exponent(Double16 a) => new(
        (Vector512.ShiftRightLogical(a.Low.AsInt64(), 52) | Vector512.Create(LaneBits.Double52)).AsDouble() - Vector512.Create(LaneBits.Double52Bias),
        (Vector512.ShiftRightLogical(a.High.AsInt64(), 52) | Vector512.Create(LaneBits.Double52)).AsDouble() - Vector512.Create(LaneBits.Double52Bias));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Double16 PowerOfTwo(Double16 n) => new(
        Vector512.ShiftLeft((n.Low + Vector512.Create(LaneBits.Double52Bias)).AsInt64(), 52).AsDouble(),
        Vector512.ShiftLeft((n.High + Vector512.Create(LaneBits.Double52Bias)).AsInt64(), 52).AsDouble());

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Double16 Less(Double16 a, Double16 b) => new(Vector512.LessThan(a.Low, b.Low), Vector512.LessThan(a.High, b.High));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Double16 LessOrEqual(Double16 a, Double16 b) => new(Vector512.LessThanOrEqual(a.Low, b.Low), Vector512.LessThanOrEqual(a.High, b.High));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Double16 Equal(Double16 a, Double16 b) => new(Vector512.Equals(a.Low, b.Low), Vector512.Equals(a.High, b.High));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Double16 Select(Double16 mask, Double16 yes, Double16 no) => new(
        Vector512.ConditionalSelect(mask.Low, yes.Low, no.Low), Vector512.ConditionalSelect(mask.High, yes.High, no.High));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static uint Bits(Double16 mask) =>
        (uint)mask.Low.ExtractMostSignificantBits() | ((uint)mask.High.ExtractMostSignificantBits() << 8);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool Any(Double16 mask) => (mask.Low | mask.High).AsInt64() != Vector512<long>.Zero;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool All(Double16 mask) => (mask.Low & mask.High).AsInt64() == Vector512<long>.AllBitsSet;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static double Largest(Double16 a)
    {
        Vector512<double> all = Vector512.MaxNative(a.Low, a.High);
        return Double8.Largest(new(all.GetLower(), all.GetUpper()));
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static double Get(Double16 a, int lane) => lane < 8 ? a.Low.GetElement(lane) : a.High.GetElement(lane - 8);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Float16 ToSingle(Double16 a) => new(Vector512.Narrow(a.Low, a.High));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Double16 FromSingle(Float16 a)
    {
        (Vector512<double> low, Vector512<double> high) = Vector512.Widen(a.Value);
        return new(low, high);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Int16 ToInt32(Double16 a) => Avx512F.IsSupported
        ? new(LaneHalves.Join(Avx512F.ConvertToVector256Int32WithTruncation(a.Low), Avx512F.ConvertToVector256Int32WithTruncation(a.High)))
        : new(Vector512.Narrow(Vector512.ConvertToInt64Native(a.Low), Vector512.ConvertToInt64Native(a.High)));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Double16 FromInt32(Int16 a)
    {
        if (Avx512F.IsSupported)
        {
            return new(Avx512F.ConvertToVector512Double(a.Value.GetLower()), Avx512F.ConvertToVector512Double(a.Value.GetUpper()));
        }

        (Vector512<long> low, Vector512<long> high) = Vector512.Widen(a.Value);
        return new(Vector512.ConvertToDouble(low), Vector512.ConvertToDouble(high));
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Float16 MaskToSingle(Double16 mask) => new(Vector512.Narrow(mask.Low.AsInt64(), mask.High.AsInt64()).AsSingle());

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Double16 MaskFromSingle(Float16 mask)
    {
        (Vector512<long> low, Vector512<long> high) = Vector512.Widen(mask.Value.AsInt32());
        return new(low.AsDouble(), high.AsDouble());
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Int16 MaskToInt32(Double16 mask) => new(MaskToSingle(mask).Value.AsInt32());

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Double16 MaskFromInt32(Int16 mask) => MaskFromSingle(new Float16(mask.Value.AsSingle()));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static unsafe Double16 Gather(Double16* column, Int16 index)
    {
        if (Avx2.IsSupported)
        {
            Vector256<int> low = index.Value.GetLower();
            Vector256<int> high = index.Value.GetUpper();
            return new(
                LaneHalves.Join(
                    Avx2.GatherVector256((double*)column, low.GetLower(), sizeof(double)),
                    Avx2.GatherVector256((double*)column, low.GetUpper(), sizeof(double))),
                LaneHalves.Join(
                    Avx2.GatherVector256((double*)column, high.GetLower(), sizeof(double)),
                    Avx2.GatherVector256((double*)column, high.GetUpper(), sizeof(double))));
        }

        Double16 gathered = default;
        for (int lane = 0; lane < 16; lane++)
        {
            Unsafe.Add(ref Unsafe.As<Double16, double>(ref gathered), lane) = ((double*)column)[index.Value.GetElement(lane)];
        }

        return gathered;
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static unsafe Double16 Broadcast(Double16* column, int element) => Of(((double*)column)[element]);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static unsafe void Put(Double16* column, int element, double value) => ((double*)column)[element] = value;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static unsafe double Take(Double16* column, int element) => ((double*)column)[element];
}
