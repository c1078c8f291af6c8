using System.Runtime.CompilerServices;

namespace LabRaytracer;

/// <summary>Box test for rays whose directions share their signs: which planes come first is known before.</summary>
internal readonly unsafe struct BvhOctantTest<F>(bool negativeX, bool negativeY, bool negativeZ) : IBvhBoxTest<F>
    where F : unmanaged, IReal<F>
{
    private readonly int _nearX = negativeX ? BvhNode.MaximumAfterMinimum : 0;
    private readonly int _nearY = negativeY ? BvhNode.MaximumAfterMinimum : 0;
    private readonly int _nearZ = negativeZ ? BvhNode.MaximumAfterMinimum : 0;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public bool Meets(BvhNode* node, in BvhSlab<F> x, in BvhSlab<F> y, in BvhSlab<F> z, F limit)
    {
        const int Across = BvhNode.MaximumAfterMinimum;
        F nearX = F.Fma(F.Of((&node->MinX)[_nearX]), x.Inverse, x.Near);
        F nearY = F.Fma(F.Of((&node->MinY)[_nearY]), y.Inverse, y.Near);
        F nearZ = F.Fma(F.Of((&node->MinZ)[_nearZ]), z.Inverse, z.Near);
        F farX = F.Fma(F.Of((&node->MinX)[Across - _nearX]), x.Inverse, x.Far);
        F farY = F.Fma(F.Of((&node->MinY)[Across - _nearY]), y.Inverse, y.Far);
        F farZ = F.Fma(F.Of((&node->MinZ)[Across - _nearZ]), z.Inverse, z.Far);
        F near = F.Max(F.Max(nearX, nearY), F.Max(nearZ, F.Zero));
        F far = F.Min(F.Min(farX, farY), F.Min(farZ, limit));
        return F.Any(F.LessOrEqual(near, far));
    }
}
