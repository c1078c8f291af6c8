using System.Runtime.CompilerServices;

namespace LabRaytracer;

/// <summary>One ray against eight boxes at a time: the numbers of <see cref="BvhRay{R, F, I}"/> of one lane, in every lane.</summary>
internal readonly unsafe struct BvhWideRay : IBvhWideTest
{
    /// <summary>1 / direction.</summary>
    public readonly Float8 InverseX, InverseY, InverseZ;

    /// <summary>Offsets of the planes that are met first.</summary>
    public readonly Float8 EarlyX, EarlyY, EarlyZ;

    /// <summary>Offsets of the planes that are met last.</summary>
    public readonly Float8 LateX, LateY, LateZ;

    /// <summary>Where in a node the planes start that are met first; those that are met last are <see cref="Across"/> away.</summary>
    public readonly int NearX, NearY, NearZ;

    /// <summary>From smallest to largest coordinates of a node.</summary>
    public const int Across = 3 * BvhWideNode.Width;

    /// <summary>Takes one lane of prepared rays.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static BvhWideRay Of<R, F, I>(in BvhRay<R, F, I> rays, int lane)
        where R : unmanaged, ILane<R, F, I>
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I> => new(
            new(Take(rays.X.Inverse, lane), Take(rays.X.Near, lane), Take(rays.X.Far, lane), (rays.NegativeX >> lane) & 1),
            new(Take(rays.Y.Inverse, lane), Take(rays.Y.Near, lane), Take(rays.Y.Far, lane), (rays.NegativeY >> lane) & 1),
            new(Take(rays.Z.Inverse, lane), Take(rays.Z.Near, lane), Take(rays.Z.Far, lane), (rays.NegativeZ >> lane) & 1));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public uint Meet(float* planes, float limit, out Float8 near)
    {
        const int Axis = BvhWideNode.Width;
        Float8 nearX = Float8.Fma(*(Float8*)(planes + NearX), InverseX, EarlyX);
        Float8 nearY = Float8.Fma(*(Float8*)(planes + NearY), InverseY, EarlyY);
        Float8 nearZ = Float8.Fma(*(Float8*)(planes + NearZ), InverseZ, EarlyZ);
        Float8 farX = Float8.Fma(*(Float8*)(planes + (Across - NearX)), InverseX, LateX);
        Float8 farY = Float8.Fma(*(Float8*)(planes + (Across + (2 * Axis) - NearY)), InverseY, LateY);
        Float8 farZ = Float8.Fma(*(Float8*)(planes + (Across + (4 * Axis) - NearZ)), InverseZ, LateZ);
        near = Float8.Max(Float8.Max(nearX, nearY), Float8.Max(nearZ, Float8.Zero));
        Float8 far = Float8.Min(Float8.Min(farX, farY), Float8.Min(farZ, Float8.Of(limit)));
        return Float8.Bits(Float8.LessOrEqual(near, far));
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private BvhWideRay(in Axis x, in Axis y, in Axis z)
    {
        (InverseX, EarlyX, LateX) = (Float8.Of(x.Inverse), Float8.Of(x.Near), Float8.Of(x.Far));
        (InverseY, EarlyY, LateY) = (Float8.Of(y.Inverse), Float8.Of(y.Near), Float8.Of(y.Far));
        (InverseZ, EarlyZ, LateZ) = (Float8.Of(z.Inverse), Float8.Of(z.Near), Float8.Of(z.Far));
        NearX = (int)x.IsNegative * Across;
        NearY = BvhWideNode.Width + ((int)y.IsNegative * Across);
        NearZ = (2 * BvhWideNode.Width) + ((int)z.IsNegative * Across);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static float Take<F>(in F lanes, int lane) => Unsafe.Add(ref Unsafe.As<F, float>(ref Unsafe.AsRef(in lanes)), lane);

    private readonly record struct Axis(float Inverse, float Near, float Far, uint IsNegative);
}
