using System.Runtime.CompilerServices;
using System.Runtime.Intrinsics;
using System.Runtime.Intrinsics.X86;

namespace LabRaytracer;

/// <summary>8 floats side by side in one 256-bit register.</summary>
[method: MethodImpl(MethodImplOptions.AggressiveInlining)]
internal readonly struct Float8(Vector256<float> value) : ILane<Float8, Float8, Int8>
{
    /// <summary>The lanes as the runtime's vector.</summary>
    public readonly Vector256<float> Value = value;

    public static int Width
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => 8;
    }

    public static bool IsSingle
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => true;
    }

    public static Float8 Zero
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => new(Vector256<float>.Zero);
    }

    public static Float8 True
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => new(Vector256<float>.AllBitsSet);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Float8 operator +(Float8 a, Float8 b) => new(a.Value + b.Value);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Float8 operator -(Float8 a, Float8 b) => new(a.Value - b.Value);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Float8 operator *(Float8 a, Float8 b) => new(a.Value * b.Value);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Float8 operator /(Float8 a, Float8 b) => new(a.Value / b.Value);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Float8 operator &(Float8 a, Float8 b) => new(a.Value & b.Value);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Float8 operator |(Float8 a, Float8 b) => new(a.Value | b.Value);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Float8 operator ^(Float8 a, Float8 b) => new(a.Value ^ b.Value);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Float8 operator -(Float8 a) => new(-a.Value);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Float8 operator ~(Float8 a) => new(~a.Value);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Float8 Of(double value) => new(Vector256.Create((float)value));

    /// <summary>The same number in every lane.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Float8 Of(float value) => new(Vector256.Create(value));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Float8 Iota(double start) => new(Vector256.Create((float)start) + Vector256.Create((float)0, 1, 2, 3, 4, 5, 6, 7));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Float8 Abs(Float8 a) => new(Vector256.Abs(a.Value));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Float8 Min(Float8 a, Float8 b) => new(X86Base.IsSupported
        ? Vector256.MinNative(a.Value, b.Value)
        : Vector256.ConditionalSelect(Vector256.LessThan(a.Value, b.Value), a.Value, b.Value));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Float8 Max(Float8 a, Float8 b) => new(X86Base.IsSupported
        ? Vector256.MaxNative(a.Value, b.Value)
        : Vector256.ConditionalSelect(Vector256.GreaterThan(a.Value, b.Value), a.Value, b.Value));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Float8 Sqrt(Float8 a) => new(Vector256.Sqrt(a.Value));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Float8 Floor(Float8 a) => new(Vector256.Floor(a.Value));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Float8 Fma(Float8 a, Float8 b, Float8 c) => new(Vector256.FusedMultiplyAdd(a.Value, b.Value, c.Value));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Float8 Exponent(Float8 a) => new(
        (Vector256.ShiftRightLogical(a.Value.AsInt32(), 23) | Vector256.Create(LaneBits.Single23)).AsSingle() - Vector256.Create(LaneBits.Single23Bias));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Float8 PowerOfTwo(Float8 n) => new(Vector256.ShiftLeft((n.Value + Vector256.Create(LaneBits.Single23Bias)).AsInt32(), 23).AsSingle());

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Float8 Less(Float8 a, Float8 b) => new(Vector256.LessThan(a.Value, b.Value));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Float8 LessOrEqual(Float8 a, Float8 b) => new(Vector256.LessThanOrEqual(a.Value, b.Value));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Float8 Equal(Float8 a, Float8 b) => new(Vector256.Equals(a.Value, b.Value));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Float8 Select(Float8 mask, Float8 yes, Float8 no) => new(Vector256.ConditionalSelect(mask.Value, yes.Value, no.Value));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static uint Bits(Float8 mask) => mask.Value.ExtractMostSignificantBits();

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool Any(Float8 mask) => mask.Value.AsInt32() != Vector256<int>.Zero;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool All(Float8 mask) => mask.Value.AsInt32() == Vector256<int>.AllBitsSet;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static double Largest(Float8 a) => Float4.Largest(new(Vector128.MaxNative(a.Value.GetLower(), a.Value.GetUpper())));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static double Get(Float8 a, int lane) => a.Value.GetElement(lane);

    /// <summary>Lanes 0 to 3.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Float4 Lower(Float8 a) => new(a.Value.GetLower());

    /// <summary>Lanes 4 to 7.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Float4 Upper(Float8 a) => new(a.Value.GetUpper());

    /// <summary>Lanes 0 to 3 of one, then of another.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Float8 Join(Float4 lower, Float4 upper) => new(Vector256.Create(lower.Value, upper.Value));

    /// <summary>The sum of all lanes of one register, three times, then that of another.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Float4 SumsOfLanes(Float8 a, Float8 b)
    {
        Vector128<float> x = a.Value.GetLower() + a.Value.GetUpper(), y = b.Value.GetLower() + b.Value.GetUpper();
        x += Vector128.Shuffle(x, Vector128.Create(2, 3, 0, 1));
        y += Vector128.Shuffle(y, Vector128.Create(2, 3, 0, 1));
        x += Vector128.Shuffle(x, Vector128.Create(1, 0, 3, 2));
        y += Vector128.Shuffle(y, Vector128.Create(1, 0, 3, 2));
        return new(Vector128.ConditionalSelect(Vector128.Create(0, 0, 0, -1).AsSingle(), y, x));
    }

    /// <summary>Two neighbouring lanes, each four times.</summary>
    /// <param name="a">The lanes.</param>
    /// <param name="pair">Which two: 0 to 3, a constant.</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Float8 Spread(Float8 a, int pair) => new(pair switch
    {
        0 => Vector256.Shuffle(a.Value, Vector256.Create(0, 0, 0, 0, 1, 1, 1, 1)),
        1 => Vector256.Shuffle(a.Value, Vector256.Create(2, 2, 2, 2, 3, 3, 3, 3)),
        2 => Vector256.Shuffle(a.Value, Vector256.Create(4, 4, 4, 4, 5, 5, 5, 5)),
        _ => Vector256.Shuffle(a.Value, Vector256.Create(6, 6, 6, 6, 7, 7, 7, 7)),
    });

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Float8 ToSingle(Float8 a) => a;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Float8 FromSingle(Float8 a) => a;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Int8 ToInt32(Float8 a) => new(Vector256.ConvertToInt32Native(a.Value));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Float8 FromInt32(Int8 a) => new(Vector256.ConvertToSingle(a.Value));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Float8 MaskToSingle(Float8 mask) => mask;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Float8 MaskFromSingle(Float8 mask) => mask;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Int8 MaskToInt32(Float8 mask) => new(mask.Value.AsInt32());

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Float8 MaskFromInt32(Int8 mask) => new(mask.Value.AsSingle());

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static unsafe Float8 Gather(Float8* column, Int8 index)
    {
        if (Avx2.IsSupported)
        {
            return new(Avx2.GatherVector256((float*)column, index.Value, sizeof(float)));
        }

        Vector256<float> gathered = default;
        for (int lane = 0; lane < 8; lane++)
        {
            Unsafe.Add(ref Unsafe.As<Vector256<float>, float>(ref gathered), lane) = ((float*)column)[index.Value.GetElement(lane)];
        }

        return new(gathered);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static unsafe Float8 Broadcast(Float8* column, int element) => new(Vector256.Create(((float*)column)[element]));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static unsafe void Put(Float8* column, int element, double value) => ((float*)column)[element] = (float)value;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static unsafe double Take(Float8* column, int element) => ((float*)column)[element];
}
