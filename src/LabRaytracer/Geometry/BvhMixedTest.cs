using System.Runtime.CompilerServices;

namespace LabRaytracer;

/// <summary>Box test for rays of any directions: each lane chooses the plane that comes first by the sign of its slope.</summary>
internal readonly unsafe struct BvhMixedTest<F> : IBvhBoxTest<F>
    where F : unmanaged, IReal<F>
{
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public bool Meets(BvhNode* node, in BvhSlab<F> x, in BvhSlab<F> y, in BvhSlab<F> z, F limit)
    {
        Planes(node->MinX, node->MaxX, x, out F nearX, out F farX);
        Planes(node->MinY, node->MaxY, y, out F nearY, out F farY);
        Planes(node->MinZ, node->MaxZ, z, out F nearZ, out F farZ);
        F near = F.Max(F.Max(nearX, nearY), F.Max(nearZ, F.Zero));
        F far = F.Min(F.Min(farX, farY), F.Min(farZ, limit));
        return F.Any(F.LessOrEqual(near, far));
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void Planes(float min, float max, in BvhSlab<F> slab, out F near, out F far)
    {
        F negative = F.Less(slab.Inverse, F.Zero);
        F low = F.Of(min), high = F.Of(max);
        near = F.Fma(F.Select(negative, high, low), slab.Inverse, slab.Near);
        far = F.Fma(F.Select(negative, low, high), slab.Inverse, slab.Far);
    }
}
