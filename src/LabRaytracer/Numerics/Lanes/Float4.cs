using System.Runtime.CompilerServices;
using System.Runtime.Intrinsics;
using System.Runtime.Intrinsics.X86;

namespace LabRaytracer;

/// <summary>4 floats side by side in one 128-bit register.</summary>
[method: MethodImpl(MethodImplOptions.AggressiveInlining)]
internal readonly struct Float4(Vector128<float> value) : ILane<Float4, Float4, Int4>, IQuad<Float4>
{
    /// <summary>The lanes as the runtime's vector.</summary>
    public readonly Vector128<float> Value = value;

    public static int Width
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => 4;
    }

    public static bool IsSingle
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => true;
    }

    public static Float4 Zero
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => new(Vector128<float>.Zero);
    }

    public static Float4 True
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => new(Vector128<float>.AllBitsSet);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Float4 operator +(Float4 a, Float4 b) => new(a.Value + b.Value);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Float4 operator -(Float4 a, Float4 b) => new(a.Value - b.Value);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Float4 operator *(Float4 a, Float4 b) => new(a.Value * b.Value);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Float4 operator /(Float4 a, Float4 b) => new(a.Value / b.Value);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Float4 operator &(Float4 a, Float4 b) => new(a.Value & b.Value);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Float4 operator |(Float4 a, Float4 b) => new(a.Value | b.Value);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Float4 operator ^(Float4 a, Float4 b) => new(a.Value ^ b.Value);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Float4 operator -(Float4 a) => new(-a.Value);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Float4 operator ~(Float4 a) => new(~a.Value);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Float4 Of(double value) => new(Vector128.Create((float)value));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Float4 Iota(double start) => new(Vector128.Create((float)start) + Vector128.Create((float)0, 1, 2, 3));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Float4 Abs(Float4 a) => new(Vector128.Abs(a.Value));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Float4 Min(Float4 a, Float4 b) => new(X86Base.IsSupported
        ? Vector128.MinNative(a.Value, b.Value)
        : Vector128.ConditionalSelect(Vector128.LessThan(a.Value, b.Value), a.Value, b.Value));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Float4 Max(Float4 a, Float4 b) => new(X86Base.IsSupported
        ? Vector128.MaxNative(a.Value, b.Value)
        : Vector128.ConditionalSelect(Vector128.GreaterThan(a.Value, b.Value), a.Value, b.Value));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Float4 Sqrt(Float4 a) => new(Vector128.Sqrt(a.Value));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Float4 Floor(Float4 a) => new(Vector128.Floor(a.Value));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Float4 Fma(Float4 a, Float4 b, Float4 c) => new(Vector128.FusedMultiplyAdd(a.Value, b.Value, c.Value));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Float4 Exponent(Float4 a) => new(
        (Vector128.ShiftRightLogical(a.Value.AsInt32(), 23) | Vector128.Create(LaneBits.Single23)).AsSingle() - Vector128.Create(LaneBits.Single23Bias));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Float4 PowerOfTwo(Float4 n) => new(Vector128.ShiftLeft((n.Value + Vector128.Create(LaneBits.Single23Bias)).AsInt32(), 23).AsSingle());

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Float4 Less(Float4 a, Float4 b) => new(Vector128.LessThan(a.Value, b.Value));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Float4 LessOrEqual(Float4 a, Float4 b) => new(Vector128.LessThanOrEqual(a.Value, b.Value));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Float4 Equal(Float4 a, Float4 b) => new(Vector128.Equals(a.Value, b.Value));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Float4 Select(Float4 mask, Float4 yes, Float4 no) => new(Vector128.ConditionalSelect(mask.Value, yes.Value, no.Value));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static uint Bits(Float4 mask) => mask.Value.ExtractMostSignificantBits();

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool Any(Float4 mask) => mask.Value.AsInt32() != Vector128<int>.Zero;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool All(Float4 mask) => mask.Value.AsInt32() == Vector128<int>.AllBitsSet;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static double Largest(Float4 a)
    {
        Vector128<float> pairs = Vector128.MaxNative(a.Value, Vector128.Shuffle(a.Value, Vector128.Create(2, 3, 0, 1)));
        return Vector128.MaxNative(pairs, Vector128.Shuffle(pairs, Vector128.Create(1, 0, 3, 2))).ToScalar();
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static double Get(Float4 a, int lane) => a.Value.GetElement(lane);

    /// <summary>Three numbers and 0.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Float4 Of(float x, float y, float z) => new(Vector128.Create(x, y, z, 0));

    /// <summary>a0 a1 + a1 a2 + a2 a0, added in this order.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float SumOfPairs(Float4 a)
    {
        Vector128<float> products = a.Value * Vector128.Shuffle(a.Value, Vector128.Create(1, 2, 0, 3));
        return products.GetElement(0) + products.GetElement(1) + products.GetElement(2);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static unsafe Float4 Load(double* numbers) => Double4.ToSingle(Double4.Load(numbers));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static unsafe Float4 LoadRounded(double* numbers) => Load(numbers);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static unsafe Float4 Load(float* numbers) => new(Vector128.Load(numbers));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void Turn(Float4 row0, Float4 row1, Float4 row2, Float4 row3, out Float4 first, out Float4 second, out Float4 third)
    {
        Vector128<float> a = row0.Value, b = row1.Value, c = row2.Value, d = row3.Value;
        if (Sse.IsSupported)
        {
            Vector128<float> ab = Sse.UnpackLow(a, b), cd = Sse.UnpackLow(c, d);
            first = new(Sse.MoveLowToHigh(ab, cd));
            second = new(Sse.MoveHighToLow(cd, ab));
            third = new(Sse.MoveLowToHigh(Sse.UnpackHigh(a, b), Sse.UnpackHigh(c, d)));
        }
        else
        {
            first = new(Vector128.Create(a.GetElement(0), b.GetElement(0), c.GetElement(0), d.GetElement(0)));
            second = new(Vector128.Create(a.GetElement(1), b.GetElement(1), c.GetElement(1), d.GetElement(1)));
            third = new(Vector128.Create(a.GetElement(2), b.GetElement(2), c.GetElement(2), d.GetElement(2)));
        }
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Float4 ToSingle(Float4 a) => a;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Float4 FromSingle(Float4 a) => a;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Int4 ToInt32(Float4 a) => new(Vector128.ConvertToInt32Native(a.Value));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Float4 FromInt32(Int4 a) => new(Vector128.ConvertToSingle(a.Value));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Float4 MaskToSingle(Float4 mask) => mask;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Float4 MaskFromSingle(Float4 mask) => mask;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Int4 MaskToInt32(Float4 mask) => new(mask.Value.AsInt32());

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Float4 MaskFromInt32(Int4 mask) => new(mask.Value.AsSingle());

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static unsafe Float4 Gather(Float4* column, Int4 index)
    {
        if (Avx2.IsSupported)
        {
            return new(Avx2.GatherVector128((float*)column, index.Value, sizeof(float)));
        }

        Vector128<float> gathered = default;
        for (int lane = 0; lane < 4; lane++)
        {
            Unsafe.Add(ref Unsafe.As<Vector128<float>, float>(ref gathered), lane) = ((float*)column)[index.Value.GetElement(lane)];
        }

        return new(gathered);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static unsafe Float4 Broadcast(Float4* column, int element) => new(Vector128.Create(((float*)column)[element]));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static unsafe void Put(Float4* column, int element, double value) => ((float*)column)[element] = (float)value;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static unsafe double Take(Float4* column, int element) => ((float*)column)[element];
}
