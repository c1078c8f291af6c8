using System.Runtime.CompilerServices;

namespace LabRaytracer;

/// <summary>One ray against eight boxes at a time: the numbers of <see cref="BvhRay{R, F, I}"/> of one lane, in every lane.</summary>
internal unsafe struct BvhWideRay : IBvhWideTest
{
    /// <summary>1 / direction.</summary>
    public Float8 InverseX, InverseY, InverseZ;

    /// <summary>Offsets of the planes that are met first.</summary>
    public Float8 EarlyX, EarlyY, EarlyZ;

    /// <summary>Offsets of the planes that are met last.</summary>
    public Float8 LateX, LateY, LateZ;

    /// <summary>Where in a node the planes start that are met first; those that are met last are <see cref="Across"/> away.</summary>
    public int NearX, NearY, NearZ;

    /// <summary>From smallest to largest coordinates of a node.</summary>
    public const int Across = 3 * BvhWideNode.Width;

    /// <summary>Goes on with another ray, one lane of prepared ones: written in place, as the whole is slow to create and to copy.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void Aim<R, F, I>(in BvhRay<R, F, I> rays, int lane)
        where R : unmanaged, ILane<R, F, I>
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I>
    {
        (InverseX, EarlyX, LateX) = (Float8.Of(Take(rays.X.Inverse, lane)), Float8.Of(Take(rays.X.Near, lane)), Float8.Of(Take(rays.X.Far, lane)));
        (InverseY, EarlyY, LateY) = (Float8.Of(Take(rays.Y.Inverse, lane)), Float8.Of(Take(rays.Y.Near, lane)), Float8.Of(Take(rays.Y.Far, lane)));
        (InverseZ, EarlyZ, LateZ) = (Float8.Of(Take(rays.Z.Inverse, lane)), Float8.Of(Take(rays.Z.Near, lane)), Float8.Of(Take(rays.Z.Far, lane)));
        NearX = (int)((rays.NegativeX >> lane) & 1) * Across;
        NearY = BvhWideNode.Width + ((int)((rays.NegativeY >> lane) & 1) * Across);
        NearZ = (2 * BvhWideNode.Width) + ((int)((rays.NegativeZ >> lane) & 1) * Across);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public readonly uint Meet(float* planes, float limit, out Float8 near)
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
    private static float Take<F>(in F lanes, int lane) => Unsafe.Add(ref Unsafe.As<F, float>(ref Unsafe.AsRef(in lanes)), lane);
}
