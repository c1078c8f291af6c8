using System.Runtime.CompilerServices;
using System.Runtime.InteropServices;

namespace LabRaytracer;

/// <content>Quick looks, which tell rays that certainly miss from the others.</content>
internal sealed unsafe partial class KernelGroup<K, R, F, I>
{
    public override bool MayBlock(int member, in RayBounds bounds, int source)
    {
        if (K.IsConvex && source == _numberOfMember[member])
        {
            return false;
        }

        ReadOnlySpan<double> looks = CollectionsMarshal.AsSpan(_looks);
        return K.HasQuickLook
            ? K.MayMeet(looks.Slice(member * K.ParameterCount, K.ParameterCount), bounds)
            : SphereKernel.MayMeet(looks.Slice(member * SphereKernel.ParameterCount, SphereKernel.ParameterCount), bounds);
    }

    /// <summary>Lists the groups of lanes that a quick look cannot tell to miss.</summary>
    /// <returns>How many.</returns>
    private int Look(int member, RayBatch<R, F, I> rays, int first, int end, int* seen)
    {
        bool isSphere = !K.HasQuickLook || typeof(K) == typeof(SphereKernel);
        int at = member * SphereKernel.ParameterCount;
        if (isSphere && rays.Bounds is { } bounds && bounds[first / Looks].Sense != 0)
        {
            rays.NarrowDirections(first, end);
            ApexLook look = new(bounds[first / Looks], new Point3D(_looks[at], _looks[at + 1], _looks[at + 2]), _looks[at + 3]);
            return look.Run(rays.SingleDirections, first, end, seen);
        }

        rays.Narrow(first, end);
        return K.HasQuickLook
            ? Look<K>(new SharedParameters<F, F, I>(_singles, member * K.ParameterCount), rays, first, end, seen)
            : Look<SphereKernel>(new SharedParameters<F, F, I>(_singles, at), rays, first, end, seen);
    }

    private static int EndOfLook(int first, int end) => Math.Min(((first / Looks) + 1) * Looks, end);

    [MethodImpl(MethodImplOptions.NoInlining)]
    private static int Look<L>(SharedParameters<F, F, I> shape, RayBatch<R, F, I> rays, int first, int end, int* seen)
        where L : struct, IShapeKernel
    {
        int count = 0;
        for (int packet = first; packet < end; packet++)
        {
            seen[count] = packet;
            count += F.Any(L.MayHit(shape, rays.LoadSingle(packet))) ? 1 : 0;
        }

        return count;
    }

    /// <summary>Centre and radius of a sphere around a box; the radius is infinite for unbounded boxes.</summary>
    private static ReadOnlySpan<double> BoundingSphere(Bounds box)
    {
        if (!box.IsFinite)
        {
            return new double[] { 0, 0, 0, double.PositiveInfinity };
        }

        Vector3D half = (box.Max - box.Min) / 2;
        Point3D center = box.Min + half;
        return new double[] { center.X, center.Y, center.Z, half.Length * (1 + 1e-6) };
    }
}
