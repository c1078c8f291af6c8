using System.Numerics;
using System.Runtime.CompilerServices;

namespace LabRaytracer;

/// <summary>Takes rays that go their own ways through a wide tree together: each node and each leaf is read once for all of a crowd that meet it, and crowds take turns while memory is on its way.</summary>
/// <remarks>
/// As with <see cref="BvhTraversal"/>, boxes only save work: the result does not depend on the tree. Rays that start near each other share most of their nodes, wherever they go then.
/// Source: Barringer, Akenine-Moeller, "Dynamic ray stream traversal", ACM Transactions on Graphics 33(4), 2014.
/// </remarks>
internal static unsafe class BvhCrowdTraversal
{
    /// <summary>Most crowds.</summary>
    public const int Most = 8;

    private const int MostPending = BvhWideNode.Width * Bvh.MaximumDepth;

    /// <summary>Visits the leaves that the rays may hit.</summary>
    /// <param name="nodes">The tree.</param>
    /// <param name="crowds">The rays, their limits set.</param>
    /// <param name="count">How many crowds, each with at least one active ray.</param>
    /// <param name="leaf">What happens at leaves.</param>
    [SkipLocalsInit]
    public static void Run<TLeaf>(BvhWideNode* nodes, BvhCrowd* crowds, int count, ref TLeaf leaf)
        where TLeaf : struct, IBvhCrowdLeaf
    {
        // For each crowd, children and the rays that meet them.
        int* pending = stackalloc int[2 * MostPending * Most];
        for (int k = 0; k < count; k++)
        {
            crowds[k].At = crowds[k].Depth = 0;
            crowds[k].Here = crowds[k].Active;
            crowds[k].IsExpected = false;
        }

        uint going = (1u << count) - 1;
        while (going != 0)
        {
            for (uint rest = going; rest != 0; rest &= rest - 1)
            {
                int k = BitOperations.TrailingZeroCount(rest);
                if (!Step(nodes, crowds + k, k, pending + (2 * k * MostPending), ref leaf))
                {
                    going &= ~(1u << k);
                }
            }
        }
    }

    /// <summary>Looks at one node or leaf, and asks for the memory of the next one; false if there is none.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static bool Step<TLeaf>(BvhWideNode* nodes, BvhCrowd* crowd, int k, int* pending, ref TLeaf leaf)
        where TLeaf : struct, IBvhCrowdLeaf
    {
        int at = crowd->At, depth = crowd->Depth;
        if (at >= 0)
        {
            depth += Open(nodes + at, crowd, pending + depth);
        }
        else
        {
            int first = ~at >> BvhWideNode.CountBits, count = ~at & ((1 << BvhWideNode.CountBits) - 1);
            if (!crowd->IsExpected)
            {
                crowd->IsExpected = true;
                leaf.Expect(first, count - 1);
                return true;
            }

            crowd->IsExpected = false;
            leaf.Visit(k, first, count, crowd->Here);
        }

        uint rays;
        do
        {
            if (depth == 0)
            {
                return false;
            }

            depth--;
            rays = (uint)pending[MostPending + depth] & crowd->Active;
        }
        while (rays == 0);

        crowd->Depth = depth;
        crowd->At = pending[depth];
        crowd->Here = rays;
        Prefetch(nodes, pending[depth], leaf.Items);
        return true;
    }

    /// <summary>Puts the children that are met aside, the farthest lowest.</summary>
    /// <returns>How many there are.</returns>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static int Open(BvhWideNode* node, BvhCrowd* crowd, int* pending)
    {
        Int8 who = BvhCrowd.Meet(crowd, node, crowd->Here, out Float8 near);
        Int8 isLeft = Int8.Equal(who, Int8.Of(0));

        // Keys: where a child is entered, with its number in the lowest bits; negative for those that are not met, which come last.
        Int8 keys = (Float8.MaskToInt32(near) & Int8.Of(~(BvhWideNode.Width - 1))) | Int8.Iota(0) | (isLeft & Int8.Of(int.MinValue));
        Int8 order = LaneOrder.Descending(keys);
        Int8.Store(LaneOrder.At(*(Int8*)((float*)node + (6 * BvhWideNode.Width)), order), pending);
        Int8.Store(LaneOrder.At(who, order), pending + MostPending);
        return BvhWideNode.Width - BitOperations.PopCount(Float8.Bits(Float8.MaskFromInt32(isLeft)));
    }

    /// <summary>Asks for the memory of a node or of a leaf's items, without a branch: which of both it is shows late, and nobody can tell before.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void Prefetch(BvhWideNode* nodes, int at, byte* items)
    {
        long isLeaf = at >> 31, node = (long)(nodes + at), item = (long)(items + ((long)(~at >> BvhWideNode.CountBits) * sizeof(MeshTriangle)));
        byte* start = (byte*)(node ^ ((node ^ item) & isLeaf));
        long step = CacheLine.Bytes - (isLeaf & (CacheLine.Bytes - sizeof(MeshTriangle)));
        CacheLine.Prefetch(start);
        CacheLine.Prefetch(start + step);
        CacheLine.Prefetch(start + (2 * step));
        CacheLine.Prefetch(start + (3 * step));
    }
}
