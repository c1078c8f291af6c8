using System.Runtime.CompilerServices;

namespace LabRaytracer;

/// <summary>Takes a group of lanes of rays through a tree of boxes, nearer children first.</summary>
/// <remarks>
/// Boxes only ever save work: the leaf decides about hits, and no leaf is left out that holds one within the limit, ties included. So the result does not depend on
/// the tree, on the order of traversal, or on which rays travel together.
/// </remarks>
internal static unsafe class BvhTraversal
{
    /// <summary>Visits the leaves that rays may hit.</summary>
    /// <param name="tree">The tree.</param>
    /// <param name="ray">Rays in the tree's space; any finite directions.</param>
    /// <param name="limit">Largest ray parameters of interest; lanes with a limit not above 0 are off.</param>
    /// <param name="leaf">What happens at leaves. The search ends when it has brought every limit below 0.</param>
    public static void Run<R, F, I, TLeaf>(Bvh tree, in RayLanes<R> ray, in R limit, ref TLeaf leaf)
        where R : unmanaged, ILane<R, F, I>
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I>
        where TLeaf : struct, IBvhLeaf<R>
    {
        if (tree.ItemCount == 0)
        {
            return;
        }

        BvhRay<R, F, I>.Prepare(tree.Frame, ray, limit, out BvhRay<R, F, I> boxRay);
        if (boxRay.Active != 0)
        {
            Run<R, F, I, TLeaf>(tree, boxRay, ref leaf);
        }
    }

    /// <summary>The same for rays that are prepared; at least one is active, and the tree has an item.</summary>
    public static void Run<R, F, I, TLeaf>(Bvh tree, in BvhRay<R, F, I> ray, ref TLeaf leaf)
        where R : unmanaged, ILane<R, F, I>
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I>
        where TLeaf : struct, IBvhLeaf<R>
    {
        if (ray.SharesSigns)
        {
            BvhOctantTest<F> test = new(ray.NegativeX != 0, ray.NegativeY != 0, ray.NegativeZ != 0);
            Descend<R, F, I, TLeaf, BvhOctantTest<F>>(tree, ray, test, ref leaf);
        }
        else
        {
            Descend<R, F, I, TLeaf, BvhMixedTest<F>>(tree, ray, default, ref leaf);
        }
    }

    [SkipLocalsInit]
    private static void Descend<R, F, I, TLeaf, TTest>(Bvh tree, in BvhRay<R, F, I> ray, TTest test, ref TLeaf leaf)
        where R : unmanaged, ILane<R, F, I>
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I>
        where TLeaf : struct, IBvhLeaf<R>
        where TTest : struct, IBvhBoxTest<F>
    {
        int* pending = stackalloc int[Bvh.MaximumDepth + 2];
        int depth = 0;
        R limit = ray.Limit, toFloat = ray.ToFloat;
        int secondFirst = ray.SecondChildFirst;
        BvhSlab<F> x = ray.X, y = ray.Y, z = ray.Z;
        F boxLimit = BvhRay<R, F, I>.LimitOf(limit, toFloat);
        BvhNode* nodes = tree.Nodes;
        BvhNode* node = nodes;
        if (!test.Meets(node, x, y, z, boxLimit))
        {
            return;
        }

        while (true)
        {
            if (node->Count <= 0)
            {
                int first = node->First;
                bool meetsFirst = test.Meets(nodes + first, x, y, z, boxLimit);
                bool meetsSecond = test.Meets(nodes + first + 1, x, y, z, boxLimit);
                if (meetsFirst | meetsSecond)
                {
                    int nearer = meetsFirst & meetsSecond ? (secondFirst >> -node->Count) & 1 : (meetsSecond ? 1 : 0);
                    if (meetsFirst & meetsSecond)
                    {
                        pending[depth++] = first + 1 - nearer;
                    }

                    node = nodes + first + nearer;
                    continue;
                }
            }
            else if (leaf.Visit(node->First, node->Count, ref limit))
            {
                boxLimit = BvhRay<R, F, I>.LimitOf(limit, toFloat);
                if (F.All(F.Less(boxLimit, F.Zero)))
                {
                    return;
                }
            }

            if (depth == 0)
            {
                return;
            }

            node = nodes + pending[--depth];
        }
    }
}
