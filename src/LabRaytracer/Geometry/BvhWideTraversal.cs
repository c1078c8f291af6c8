using System.Numerics;
using System.Runtime.CompilerServices;

namespace LabRaytracer;

/// <summary>Takes one ray through a wide tree, nearer children first.</summary>
/// <remarks>As with <see cref="BvhTraversal"/>, boxes only save work: the result does not depend on the tree.</remarks>
internal static unsafe class BvhWideTraversal
{
    private const int MostPending = (BvhWideNode.Width - 1) * Bvh.MaximumDepth;

    /// <summary>Visits the leaves that the ray may hit.</summary>
    [SkipLocalsInit]
    public static void Run<TLeaf>(BvhWideNode* nodes, in BvhWideRay ray, float limit, ref TLeaf leaf)
        where TLeaf : struct, IBvhWideLeaf
    {
        Pending* pending = stackalloc Pending[MostPending];
        float* nears = stackalloc float[BvhWideNode.Width];
        BvhWideRay own = ray;
        int depth = 0, at = 0;
        while (true)
        {
            if (at >= 0)
            {
                BvhWideNode* node = nodes + at;
                uint met = Meet(node->Planes, own, limit, out Float8 near);
                if (met != 0)
                {
                    int child = BitOperations.TrailingZeroCount(met);
                    met &= met - 1;
                    if (met == 0)
                    {
                        at = node->Children[child];
                        continue;
                    }

                    *(Float8*)nears = near;
                    at = Sort(node, child, met, nears, pending, ref depth);
                    continue;
                }
            }
            else
            {
                leaf.Visit(~at >> BvhWideNode.CountBits, ~at & ((1 << BvhWideNode.CountBits) - 1), ref limit);
                if (limit < 0)
                {
                    return;
                }
            }

            do
            {
                if (depth == 0)
                {
                    return;
                }

                depth--;
            }
            while (pending[depth].Near > limit);

            at = pending[depth].Child;
        }
    }

    /// <summary>Bits of the children whose boxes the ray meets, and where it enters them.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static uint Meet(float* planes, in BvhWideRay ray, float limit, out Float8 near)
    {
        const int Across = BvhWideRay.Across, Axis = BvhWideNode.Width;
        Float8 nearX = Float8.Fma(*(Float8*)(planes + ray.NearX), ray.InverseX, ray.EarlyX);
        Float8 nearY = Float8.Fma(*(Float8*)(planes + ray.NearY), ray.InverseY, ray.EarlyY);
        Float8 nearZ = Float8.Fma(*(Float8*)(planes + ray.NearZ), ray.InverseZ, ray.EarlyZ);
        Float8 farX = Float8.Fma(*(Float8*)(planes + (Across - ray.NearX)), ray.InverseX, ray.LateX);
        Float8 farY = Float8.Fma(*(Float8*)(planes + (Across + (2 * Axis) - ray.NearY)), ray.InverseY, ray.LateY);
        Float8 farZ = Float8.Fma(*(Float8*)(planes + (Across + (4 * Axis) - ray.NearZ)), ray.InverseZ, ray.LateZ);
        near = Float8.Max(Float8.Max(nearX, nearY), Float8.Max(nearZ, Float8.Zero));
        Float8 far = Float8.Min(Float8.Min(farX, farY), Float8.Min(farZ, Float8.Of(limit)));
        return Float8.Bits(Float8.LessOrEqual(near, far));
    }

    /// <summary>Puts all children but the nearest aside, the farthest lowest; returns the nearest.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static int Sort(BvhWideNode* node, int first, uint others, float* nears, Pending* pending, ref int depth)
    {
        int bottom = depth, top = depth;
        Pending nearest = new() { Near = nears[first], Child = node->Children[first] };
        do
        {
            int child = BitOperations.TrailingZeroCount(others);
            others &= others - 1;
            Pending next = new() { Near = nears[child], Child = node->Children[child] };
            if (next.Near < nearest.Near)
            {
                (next, nearest) = (nearest, next);
            }

            int place = top++;
            while (place > bottom && pending[place - 1].Near < next.Near)
            {
                pending[place] = pending[place - 1];
                place--;
            }

            pending[place] = next;
        }
        while (others != 0);

        depth = top;
        return nearest.Child;
    }

    private struct Pending
    {
        public float Near;
        public int Child;
    }
}
