using System.Runtime.CompilerServices;
using System.Runtime.Intrinsics;
using System.Runtime.Intrinsics.X86;

namespace LabRaytracer;

/// <summary>4 doubles side by side in one 256-bit register.</summary>
[method: MethodImpl(MethodImplOptions.AggressiveInlining)]
internal readonly struct Double4(Vector256<double> value) : ILane<Double4, Float4, Int4>, IQuad<Double4>
{
    /// <summary>The lanes as the runtime's vector.</summary>
    public readonly Vector256<double> Value = value;

    public static int Width
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => 4;
    }

    public static bool IsSingle
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => false;
    }

    public static Double4 Zero
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => new(Vector256<double>.Zero);
    }

    public static Double4 True
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => new(Vector256<double>.AllBitsSet);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Double4 operator +(Double4 a, Double4 b) => new(a.Value + b.Value);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Double4 operator -(Double4 a, Double4 b) => new(a.Value - b.Value);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Double4 operator *(Double4 a, Double4 b) => new(a.Value * b.Value);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Double4 operator /(Double4 a, Double4 b) => new(a.Value / b.Value);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Double4 operator &(Double4 a, Double4 b) => new(a.Value & b.Value);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Double4 operator |(Double4 a, Double4 b) => new(a.Value | b.Value);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Double4 operator ^(Double4 a, Double4 b) => new(a.Value ^ b.Value);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Double4 operator -(Double4 a) => new(-a.Value);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Double4 operator ~(Double4 a) => new(~a.Value);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Double4 Of(double value) => new(Vector256.Create(value));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Double4 Iota(double start) => new(Vector256.Create(start) + Vector256.Create((double)0, 1, 2, 3));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Double4 Abs(Double4 a) => new(Vector256.Abs(a.Value));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Double4 Min(Double4 a, Double4 b) => new(X86Base.IsSupported
        ? Vector256.MinNative(a.Value, b.Value)
        : Vector256.ConditionalSelect(Vector256.LessThan(a.Value, b.Value), a.Value, b.Value));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Double4 Max(Double4 a, Double4 b) => new(X86Base.IsSupported
        ? Vector256.MaxNative(a.Value, b.Value)
        : Vector256.ConditionalSelect(Vector256.GreaterThan(a.Value, b.Value), a.Value, b.Value));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Double4 Sqrt(Double4 a) => new(Vector256.Sqrt(a.Value));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Double4 Floor(Double4 a) => new(Vector256.Floor(a.Value));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Double4 Fma(Double4 a, Double4 b, Double4 c) => new(Vector256.FusedMultiplyAdd(a.Value, b.Value, c.Value));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Double4 Exponent(Double4 a) => new(
        (Vector256.ShiftRightLogical(a.Value.AsInt64(), 52) | Vector256.Create(LaneBits.Double52)).AsDouble() - Vector256.Create(LaneBits.Double52Bias));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Double4 PowerOfTwo(Double4 n) => new(Vector256.ShiftLeft((n.Value + Vector256.Create(LaneBits.Double52Bias)).AsInt64(), 52).AsDouble());

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Double4 Less(Double4 a, Double4 b) => new(Vector256.LessThan(a.Value, b.Value));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Double4 LessOrEqual(Double4 a, Double4 b) => new(Vector256.LessThanOrEqual(a.Value, b.Value));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Double4 Equal(Double4 a, Double4 b) => new(Vector256.Equals(a.Value, b.Value));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Double4 Select(Double4 mask, Double4 yes, Double4 no) => new(Vector256.ConditionalSelect(mask.Value, yes.Value, no.Value));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static uint Bits(Double4 mask) => mask.Value.ExtractMostSignificantBits();

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool Any(Double4 mask) => mask.Value.AsInt64() != Vector256<long>.Zero;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool All(Double4 mask) => mask.Value.AsInt64() == Vector256<long>.AllBitsSet;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static double Largest(Double4 a) => Double2.Largest(new(Vector128.MaxNative(a.Value.GetLower(), a.Value.GetUpper())));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static double Get(Double4 a, int lane) => a.Value.GetElement(lane);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static unsafe Double4 Load(double* numbers) => new(Vector256.Load(numbers));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static unsafe Double4 LoadRounded(double* numbers) => FromSingle(Float4.Load(numbers));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static unsafe Double4 Load(float* numbers) => FromSingle(Float4.Load(numbers));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void Turn(Double4 row0, Double4 row1, Double4 row2, Double4 row3, out Double4 first, out Double4 second, out Double4 third)
    {
        Vector256<double> a = row0.Value, b = row1.Value, c = row2.Value, d = row3.Value;
        if (Avx.IsSupported)
        {
            Vector256<double> ab = Avx.UnpackLow(a, b), cd = Avx.UnpackLow(c, d);
            first = new(Avx.Permute2x128(ab, cd, 0x20));
            second = new(Avx.Permute2x128(Avx.UnpackHigh(a, b), Avx.UnpackHigh(c, d), 0x20));
            third = new(Avx.Permute2x128(ab, cd, 0x31));
        }
        else
        {
            first = new(Vector256.Create(a.GetElement(0), b.GetElement(0), c.GetElement(0), d.GetElement(0)));
            second = new(Vector256.Create(a.GetElement(1), b.GetElement(1), c.GetElement(1), d.GetElement(1)));
            third = new(Vector256.Create(a.GetElement(2), b.GetElement(2), c.GetElement(2), d.GetElement(2)));
        }
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Float4 ToSingle(Double4 a) => new(Avx.IsSupported ? Avx.ConvertToVector128Single(a.Value) : Vector128.Narrow(a.Value.GetLower(), a.Value.GetUpper()));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Double4 FromSingle(Float4 a)
    {
        if (Avx.IsSupported)
        {
            return new(Avx.ConvertToVector256Double(a.Value));
        }

        (Vector128<double> low, Vector128<double> high) = Vector128.Widen(a.Value);
        return new(Vector256.Create(low, high));
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Int4 ToInt32(Double4 a) => new(Avx.IsSupported
        ? Avx.ConvertToVector128Int32WithTruncation(a.Value)
        : Vector128.Create((int)a.Value.GetElement(0), (int)a.Value.GetElement(1), (int)a.Value.GetElement(2), (int)a.Value.GetElement(3)));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Double4 FromInt32(Int4 a) => new(Avx.IsSupported
        ? Avx.ConvertToVector256Double(a.Value)
        : Vector256.Create((double)a.Value.GetElement(0), a.Value.GetElement(1), a.Value.GetElement(2), a.Value.GetElement(3)));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Float4 MaskToSingle(Double4 mask) => new(Vector128.Narrow(mask.Value.GetLower().AsInt64(), mask.Value.GetUpper().AsInt64()).AsSingle());

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Double4 MaskFromSingle(Float4 mask)
    {
        (Vector128<long> low, Vector128<long> high) = Vector128.Widen(mask.Value.AsInt32());
        return new(Vector256.Create(low, high).AsDouble());
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Int4 MaskToInt32(Double4 mask) => new(MaskToSingle(mask).Value.AsInt32());

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Double4 MaskFromInt32(Int4 mask) => MaskFromSingle(new Float4(mask.Value.AsSingle()));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static unsafe Double4 Gather(Double4* column, Int4 index)
    {
        if (Avx2.IsSupported)
        {
            return new(Avx2.GatherVector256((double*)column, index.Value, sizeof(double)));
        }

        Vector256<double> gathered = default;
        for (int lane = 0; lane < 4; lane++)
        {
            Unsafe.Add(ref Unsafe.As<Vector256<double>, double>(ref gathered), lane) = ((double*)column)[index.Value.GetElement(lane)];
        }

        return new(gathered);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static unsafe Double4 Broadcast(Double4* column, int element) => new(Vector256.Create(((double*)column)[element]));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static unsafe void Put(Double4* column, int element, double value) => ((double*)column)[element] = value;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static unsafe double Take(Double4* column, int element) => ((double*)column)[element];
}
