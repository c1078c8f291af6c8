using System.Numerics;
using System.Runtime.CompilerServices;

namespace LabRaytracer;

/// <summary>Takes a pencil of rays through a wide tree.</summary>
/// <remarks>
/// The same leaves as <see cref="BvhWideTraversal"/>, but where nodes put their children aside no branch depends on how many are met: about three of eight, in no order,
/// so that processors guess wrong several times a node.
/// </remarks>
internal static unsafe class PencilTraversal
{
    /// <summary>Eight children are written at a time, whether they are met or not.</summary>
    private const int MostPending = ((BvhWideNode.Width - 1) * Bvh.MaximumDepth) + BvhWideNode.Width;

    private const int MostLeaves = 16;

    /// <summary>Visits the leaves that the pencil may hit, in any order.</summary>
    [SkipLocalsInit]
    public static void Run<TLeaf>(BvhWideNode* nodes, in PencilBoxes test, float limit, ref TLeaf leaf)
        where TLeaf : struct, IBvhWideLeaf
    {
        int* pendingNode = stackalloc int[MostPending], leafNode = stackalloc int[MostLeaves + BvhWideNode.Width];
        byte* pendingChild = stackalloc byte[MostPending], leafChild = stackalloc byte[MostLeaves + BvhWideNode.Width];
        int depth = 0, leaves = 0, at = 0;
        while (limit >= 0)
        {
            BvhWideNode* node = nodes + at;
            uint met = test.Meet(node->Planes, limit, out _), isLeaf = Float8.Bits(*(Float8*)node->Children);
            Int8 number = Int8.Of(at);
            Int8.Store(number, pendingNode + depth);
            *(ulong*)(pendingChild + depth) = LanePlaces.Of(met & ~isLeaf);
            depth += BitOperations.PopCount(met & ~isLeaf);
            Int8.Store(number, leafNode + leaves);
            *(ulong*)(leafChild + leaves) = LanePlaces.Of(met & isLeaf);
            leaves += BitOperations.PopCount(met & isLeaf);
            if (leaves >= MostLeaves || depth == 0)
            {
                for (int k = 0; k < leaves; k++)
                {
                    leaf.Expect(~nodes[leafNode[k]].Children[leafChild[k]] >> BvhWideNode.CountBits);
                }

                for (int k = 0; k < leaves && limit >= 0; k++)
                {
                    Visit(nodes + leafNode[k], leafChild[k], ref leaf, ref limit);
                }

                leaves = 0;
                if (depth == 0)
                {
                    return;
                }
            }

            depth--;
            at = nodes[pendingNode[depth]].Children[pendingChild[depth]];
        }
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void Visit<TLeaf>(BvhWideNode* node, int child, ref TLeaf leaf, ref float limit)
        where TLeaf : struct, IBvhWideLeaf
    {
        int code = ~node->Children[child], first = code >> BvhWideNode.CountBits;
        leaf.Visit(first, code & ((1 << BvhWideNode.CountBits) - 1), node->Planes + child, ref limit);
    }
}
