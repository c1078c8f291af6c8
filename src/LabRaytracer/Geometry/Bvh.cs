using System.Runtime.InteropServices;

namespace LabRaytracer;

/// <summary>A binary tree of boxes (bounding volume hierarchy), searched by <see cref="BvhTraversal"/>.</summary>
/// <remarks>
/// Immutable, thread safe. Boxes are floats, rounded outward, relative to the centre of <see cref="Frame"/>: a scene far from the
/// origin keeps tight boxes. Node 0 is the root, node 1 is unused (children pairs start at even numbers).
/// </remarks>
internal sealed unsafe class Bvh : IDisposable
{
    /// <summary>No path from the root to a leaf has more inner nodes.</summary>
    public const int MaximumDepth = 60;

    private readonly LaneMemory _memory = new();

    private Bvh(int itemCount, int nodeCount)
    {
        NodeCount = nodeCount;
        ItemCount = itemCount;
        Nodes = _memory.Column<BvhNode>(nodeCount, 1);
    }

    /// <summary>Where the tree is.</summary>
    public BvhFrame Frame { get; private set; }

    /// <summary>Number of nodes, the unused one included.</summary>
    public int NodeCount { get; }

    /// <summary>Number of items.</summary>
    public int ItemCount { get; }

    /// <summary>The nodes.</summary>
    public BvhNode* Nodes { get; }

    /// <summary>Bytes of the nodes.</summary>
    public long Bytes => _memory.Bytes;

    /// <summary>Builds a tree.</summary>
    /// <param name="items">What it sorts.</param>
    /// <param name="cost">When to stop splitting.</param>
    /// <param name="threads">Threads that may work on it, at least 1. The tree does not depend on it.</param>
    /// <param name="order">Item numbers in the order of the leaves.</param>
    public static Bvh Build<TItems>(TItems items, BvhCost cost, int threads, out int[] order)
        where TItems : struct, IBvhItems
    {
        int count = items.Count;
        order = new int[count];
        if (count == 0)
        {
            return new Bvh(0, 0);
        }

        Point3D center = CenterOf(items.All);
        BvhReference* references = (BvhReference*)NativeMemory.AlignedAlloc((nuint)count * (nuint)sizeof(BvhReference), 64);
        BvhNode* sparse = (BvhNode*)NativeMemory.AlignedAlloc(2 * (nuint)count * (nuint)sizeof(BvhNode), 64);
        try
        {
            BvhRange all = BvhReferences.Fill(items, center, references, threads);
            int nodeCount = new BvhBuilder(references, sparse, cost, threads).Build(all);
            Bvh tree = new(count, nodeCount);
            BvhBuilder.Compact(sparse, tree.Nodes);
            for (int i = 0; i < count; i++)
            {
                order[i] = references[i].Number;
            }

            tree.Frame = new BvhFrame(center, *tree.Nodes);
            return tree;
        }
        finally
        {
            NativeMemory.AlignedFree(references);
            NativeMemory.AlignedFree(sparse);
        }
    }

    public void Dispose() => _memory.Dispose();

    /// <summary>The middle of all items where they are far from the origin, else the origin, where nothing is lost by the subtraction.</summary>
    private static Point3D CenterOf(in Bounds all) => new(Middle(all.Min.X, all.Max.X), Middle(all.Min.Y, all.Max.Y), Middle(all.Min.Z, all.Max.Z));

    private static double Middle(double min, double max)
    {
        double middle = (0.5 * min) + (0.5 * max);
        return Math.Abs(middle) > 4 * (max - min) ? middle : 0;
    }
}
