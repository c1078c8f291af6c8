using System.Runtime.CompilerServices;

namespace LabRaytracer;

/// <summary>One ray against eight boxes at a time: the numbers of <see cref="BvhRay{R, F, I}"/> in every lane.</summary>
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

    /// <param name="ray">The prepared ray.</param>
    public BvhWideRay(in BvhRay<Double1, Float1, Int1> ray)
    {
        (InverseX, EarlyX, LateX) = (Float8.Of(ray.X.Inverse.Value), Float8.Of(ray.X.Near.Value), Float8.Of(ray.X.Far.Value));
        (InverseY, EarlyY, LateY) = (Float8.Of(ray.Y.Inverse.Value), Float8.Of(ray.Y.Near.Value), Float8.Of(ray.Y.Far.Value));
        (InverseZ, EarlyZ, LateZ) = (Float8.Of(ray.Z.Inverse.Value), Float8.Of(ray.Z.Near.Value), Float8.Of(ray.Z.Far.Value));
        NearX = ray.NegativeX != 0 ? Across : 0;
        NearY = BvhWideNode.Width + (ray.NegativeY != 0 ? Across : 0);
        NearZ = (2 * BvhWideNode.Width) + (ray.NegativeZ != 0 ? Across : 0);
    }

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
}
