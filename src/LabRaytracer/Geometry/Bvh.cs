using System.Runtime.InteropServices;

namespace LabRaytracer;

/// <summary>A binary tree of boxes (bounding volume hierarchy), searched by <see cref="BvhTraversal"/>.</summary>
/// <remarks>
/// Immutable, thread safe. Boxes are floats, rounded outward, relative to <see cref="CenterX"/>, <see cref="CenterY"/>, <see cref="CenterZ"/>: a scene far from the
/// origin keeps tight boxes. Node 0 is the root, node 1 is unused (children pairs start at even numbers).
/// </remarks>
internal sealed unsafe class Bvh : IDisposable
{
    /// <summary>No path from the root to a leaf has more inner nodes.</summary>
    public const int MaximumDepth = 60;

    private readonly LaneMemory _memory = new();

    private Bvh(Point3D center, int itemCount, int nodeCount)
    {
        CenterX = center.X;
        CenterY = center.Y;
        CenterZ = center.Z;
        NodeCount = nodeCount;
        ItemCount = itemCount;
        Nodes = _memory.Column<BvhNode>(nodeCount, 1);
    }

    /// <summary>Subtracted from coordinates before they meet the boxes.</summary>
    public double CenterX { get; }

    /// <inheritdoc cref="CenterX"/>
    public double CenterY { get; }

    /// <inheritdoc cref="CenterX"/>
    public double CenterZ { get; }

    /// <summary>Largest coordinate of the root's box, relative to the centre, in magnitude.</summary>
    public float SizeX { get; private set; }

    /// <inheritdoc cref="SizeX"/>
    public float SizeY { get; private set; }

    /// <inheritdoc cref="SizeX"/>
    public float SizeZ { get; private set; }

    /// <summary>Sum of the magnitudes of all coordinates of box and centre.</summary>
    public double Size { get; private set; }

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
            return new Bvh(Point3D.Origin, 0, 0);
        }

        Point3D center = CenterOf(items.All);
        BvhReference* references = (BvhReference*)NativeMemory.AlignedAlloc((nuint)count * (nuint)sizeof(BvhReference), 64);
        BvhNode* sparse = (BvhNode*)NativeMemory.AlignedAlloc(2 * (nuint)count * (nuint)sizeof(BvhNode), 64);
        try
        {
            BvhRange all = BvhReferences.Fill(items, center, references, threads);
            int nodeCount = new BvhBuilder(references, sparse, cost, threads).Build(all);
            Bvh tree = new(center, count, nodeCount);
            BvhBuilder.Compact(sparse, tree.Nodes);
            for (int i = 0; i < count; i++)
            {
                order[i] = references[i].Number;
            }

            tree.Measure();
            return tree;
        }
        finally
        {
            NativeMemory.AlignedFree(references);
            NativeMemory.AlignedFree(sparse);
        }
    }

    public void Dispose() => _memory.Dispose();

    private void Measure()
    {
        SizeX = Math.Max(Math.Abs(Nodes->MinX), Math.Abs(Nodes->MaxX));
        SizeY = Math.Max(Math.Abs(Nodes->MinY), Math.Abs(Nodes->MaxY));
        SizeZ = Math.Max(Math.Abs(Nodes->MinZ), Math.Abs(Nodes->MaxZ));
        Size = (double)SizeX + SizeY + SizeZ + Math.Abs(CenterX) + Math.Abs(CenterY) + Math.Abs(CenterZ);
    }

    /// <summary>The middle of all items where they are far from the origin, else the origin, where nothing is lost by the subtraction.</summary>
    private static Point3D CenterOf(in Bounds all) => new(Middle(all.Min.X, all.Max.X), Middle(all.Min.Y, all.Max.Y), Middle(all.Min.Z, all.Max.Z));

    private static double Middle(double min, double max)
    {
        double middle = (0.5 * min) + (0.5 * max);
        return Math.Abs(middle) > 4 * (max - min) ? middle : 0;
    }
}
