using System.Runtime.CompilerServices;

namespace LabRaytracer;

/// <summary>Leaves of a wide tree for a bundle of rays: each ray meets the box of a leaf before its items.</summary>
/// <typeparam name="R">Lane type of geometry.</typeparam>
/// <typeparam name="F">Float lanes of the same width.</typeparam>
/// <typeparam name="I">Integer lanes of the same width.</typeparam>
/// <typeparam name="TLeaf">What happens then.</typeparam>
/// <param name="rays">The rays; they stay where they are.</param>
/// <param name="items">What happens at items.</param>
internal unsafe struct BvhBundleLeaf<R, F, I, TLeaf>(BvhRay<R, F, I>* rays, in TLeaf items) : IBvhWideLeaf
    where R : unmanaged, ILane<R, F, I>
    where F : unmanaged, ILane<F, F, I>
    where I : unmanaged, IIndexLane<I>
    where TLeaf : struct, IBvhLeaf<R>
{
    /// <summary>What was found.</summary>
    public TLeaf Items = items;

    private F _limit = BvhRay<R, F, I>.LimitOf(rays->Limit, rays->ToFloat);

    /// <summary>The largest limit of any ray, in the units of boxes.</summary>
    public readonly float LargestLimit => (float)F.Largest(_limit);

    public static bool IsOrdered => true;

    public void Expect(int first)
    {
    }

    public void Visit(int first, int count, float* box, ref float limit)
    {
        if (MeetsAny(box) && Items.Visit(first, count, ref rays->Limit))
        {
            _limit = BvhRay<R, F, I>.LimitOf(rays->Limit, rays->ToFloat);
            limit = LargestLimit;
        }
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private readonly bool MeetsAny(float* box)
    {
        const int Axis = BvhWideNode.Width;
        int nearX = rays->NegativeX != 0 ? BvhWideRay.Across : 0, nearY = rays->NegativeY != 0 ? BvhWideRay.Across : 0, nearZ = rays->NegativeZ != 0 ? BvhWideRay.Across : 0;
        float* x = box, y = box + Axis, z = box + (2 * Axis);
        F near = F.Max(F.Max(Plane(x + nearX, rays->X.Inverse, rays->X.Near), Plane(y + nearY, rays->Y.Inverse, rays->Y.Near)), F.Max(Plane(z + nearZ, rays->Z.Inverse, rays->Z.Near), F.Zero));
        F far = F.Min(
            F.Min(Plane(x + (BvhWideRay.Across - nearX), rays->X.Inverse, rays->X.Far), Plane(y + (BvhWideRay.Across - nearY), rays->Y.Inverse, rays->Y.Far)),
            F.Min(Plane(z + (BvhWideRay.Across - nearZ), rays->Z.Inverse, rays->Z.Far), _limit));
        return F.Any(F.LessOrEqual(near, far));
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static F Plane(float* coordinate, F inverse, F offset) => F.Fma(F.Of(*coordinate), inverse, offset);
}
