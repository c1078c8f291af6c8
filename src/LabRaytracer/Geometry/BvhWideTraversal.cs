using System.Numerics;
using System.Runtime.CompilerServices;

namespace LabRaytracer;

/// <summary>Takes a ray, or several together, through a wide tree, nearer children first.</summary>
/// <remarks>As with <see cref="BvhTraversal"/>, boxes only save work: the result does not depend on the tree.</remarks>
internal static unsafe class BvhWideTraversal
{
    private const int MostPending = (BvhWideNode.Width - 1) * Bvh.MaximumDepth;

    /// <summary>Visits the leaves that the ray may hit.</summary>
    /// <remarks>The test stays where it is: a copy of hundreds of bytes takes as long as several nodes.</remarks>
    [SkipLocalsInit]
    public static void Run<TTest, TLeaf>(BvhWideNode* nodes, ref TTest test, float limit, ref TLeaf leaf)
        where TTest : struct, IBvhWideTest
        where TLeaf : struct, IBvhWideLeaf
    {
        Pending* pending = stackalloc Pending[MostPending];
        float* nears = stackalloc float[BvhWideNode.Width];
        int depth = 0, at = 0;
        float* box = null;
        while (true)
        {
            if (at >= 0)
            {
                BvhWideNode* node = nodes + at;
                uint met = test.Meet(node->Planes, limit, out Float8 near);
                if (met != 0)
                {
                    for (uint rest = met; rest != 0; rest &= rest - 1)
                    {
                        int next = node->Children[BitOperations.TrailingZeroCount(rest)];
                        if (next < 0)
                        {
                            leaf.Expect(~next >> BvhWideNode.CountBits);
                        }
                    }

                    int child = BitOperations.TrailingZeroCount(met);
                    met &= met - 1;
                    if (met == 0)
                    {
                        at = node->Children[child];
                        box = node->Planes + child;
                        continue;
                    }

                    *(Float8*)nears = near;
                    at = Sort(node, child, met, nears, pending, ref depth, out box);
                    continue;
                }
            }
            else
            {
                leaf.Visit(~at >> BvhWideNode.CountBits, ~at & ((1 << BvhWideNode.CountBits) - 1), box, ref limit);
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
            box = pending[depth].Box;
        }
    }

    /// <summary>Puts all children but the nearest aside, the farthest lowest; returns the nearest.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static int Sort(BvhWideNode* node, int first, uint others, float* nears, Pending* pending, ref int depth, out float* box)
    {
        int bottom = depth, top = depth;
        Pending nearest = new() { Near = nears[first], Child = node->Children[first], Box = node->Planes + first };
        do
        {
            int child = BitOperations.TrailingZeroCount(others);
            others &= others - 1;
            Pending next = new() { Near = nears[child], Child = node->Children[child], Box = node->Planes + child };
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
        box = nearest.Box;
        return nearest.Child;
    }

    private struct Pending
    {
        public float Near;
        public int Child;
        public float* Box;
    }
}
