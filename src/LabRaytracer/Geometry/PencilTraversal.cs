using System.Numerics;
using System.Runtime.CompilerServices;

namespace LabRaytracer;

/// <summary>Takes a pencil of rays through a wide tree.</summary>
/// <remarks>
/// The same leaves as <see cref="BvhWideTraversal"/>, but where nodes put their children aside no branch depends on how many are met: about three of eight, in no order,
/// so that processors guess wrong several times a node. Leaves are gathered before they are visited; of two branches of the tree, one is searched while the other's next node comes.
/// </remarks>
internal static unsafe class PencilTraversal
{
    /// <summary>With more nodes that wait, none is taken ahead: then, as always in a search that goes on with the last one, each step down adds one node's children at most.</summary>
    private const int MostAhead = 256;

    /// <summary>Eight children are written at a time, whether they are met or not.</summary>
    private const int MostPending = MostAhead + ((BvhWideNode.Width - 1) * (Bvh.MaximumDepth + 1)) + BvhWideNode.Width;

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
            // The node that is next comes from memory while this one is tested.
            int next = -1;
            if (depth is > 0 and < MostAhead)
            {
                depth--;
                next = nodes[pendingNode[depth]].Children[pendingChild[depth]];
                Expect(nodes + next);
            }

            BvhWideNode* node = nodes + at;
            uint met = test.Meet(node->Planes, limit, out _), isLeaf = Float8.Bits(*(Float8*)node->Children);
            Int8 number = Int8.Of(at);
            Int8.Store(number, pendingNode + depth);
            *(ulong*)(pendingChild + depth) = LanePlaces.Of(met & ~isLeaf);
            depth += BitOperations.PopCount(met & ~isLeaf);
            Int8.Store(number, leafNode + leaves);
            *(ulong*)(leafChild + leaves) = LanePlaces.Of(met & isLeaf);
            leaves += BitOperations.PopCount(met & isLeaf);
            bool isLast = depth == 0 && next < 0;
            if (leaves >= MostLeaves || isLast)
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
                if (isLast)
                {
                    return;
                }
            }

            if (next < 0)
            {
                depth--;
                next = nodes[pendingNode[depth]].Children[pendingChild[depth]];
            }

            at = next;
        }
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void Expect(BvhWideNode* node)
    {
        for (int at = 0; at < sizeof(BvhWideNode); at += CacheLine.Bytes)
        {
            CacheLine.Prefetch((byte*)node + at);
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
