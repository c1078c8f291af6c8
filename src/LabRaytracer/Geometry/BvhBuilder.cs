using System.Numerics;
using System.Runtime.CompilerServices;

namespace LabRaytracer;

/// <summary>Builds a tree of boxes from the top by the surface area heuristic over bins.</summary>
/// <remarks>
/// Wald, "On fast construction of SAH-based bounding volume hierarchies", IEEE Symposium on Interactive Ray Tracing, 2007.
/// A split between items p - 1 and p is the only one at p, so its children get the slots 2 p and 2 p + 1 of a sparse array: threads need no common counter,
/// and the tree is the same for any number of them.
/// </remarks>
internal sealed unsafe class BvhBuilder
{
    private const int TaskItems = 8192;
    private readonly BvhReference* _references;
    private readonly BvhNode* _nodes;
    private readonly BvhCost _cost;
    private readonly TaskFactory? _tasks;
    private int _nodeCount = 2;

    /// <summary>Prepares a build.</summary>
    /// <param name="references">The items' boxes; reordered by the build.</param>
    /// <param name="nodes">Room for two nodes an item.</param>
    /// <param name="cost">When to stop splitting.</param>
    /// <param name="threads">Threads that may work, at least 1.</param>
    public BvhBuilder(BvhReference* references, BvhNode* nodes, BvhCost cost, int threads)
    {
        _references = references;
        _nodes = nodes;
        _cost = cost;
        if (threads > 1)
        {
            TaskScheduler scheduler = new ConcurrentExclusiveSchedulerPair(TaskScheduler.Default, threads).ConcurrentScheduler;
            _tasks = new TaskFactory(CancellationToken.None, TaskCreationOptions.AttachedToParent, TaskContinuationOptions.None, scheduler);
        }
    }

    /// <summary>Builds the tree over a range of all items; returns its number of nodes, the unused one included.</summary>
    public int Build(in BvhRange all)
    {
        if (_tasks == null || all.Count <= TaskItems)
        {
            _nodeCount += Split(0, all, 0);
        }
        else
        {
            StartTask(0, all, 0).Wait();
        }

        return _nodeCount;
    }

    /// <summary>Copies a sparse tree into consecutive nodes, parents before children.</summary>
    public static void Compact(BvhNode* sparse, BvhNode* dense)
    {
        int* pending = stackalloc int[Bvh.MaximumDepth + 2];
        int depth = 0;
        int next = 2;
        dense[0] = sparse[0];
        pending[depth++] = 0;
        while (depth > 0)
        {
            BvhNode* node = dense + pending[--depth];
            if (node->Count > 0)
            {
                continue;
            }

            BvhNode* children = sparse + node->First;
            dense[next] = children[0];
            dense[next + 1] = children[1];
            node->First = next;
            pending[depth++] = next + 1;
            pending[depth++] = next;
            next += 2;
        }
    }

    /// <summary>Writes the node of a range and all below it; returns how many nodes were made below it by this thread.</summary>
    private int Split(int slot, in BvhRange whole, int depth)
    {
        BvhRange range = whole;
        int made = 0;
        while (true)
        {
            BvhNode* node = _nodes + slot;
            Store(node, range);
            if (!Divide(range, depth, out BvhRange left, out BvhRange right, out int axis))
            {
                return made;
            }

            int children = 2 * right.First;
            node->First = children;
            node->Count = -axis;
            made += 2;
            depth++;
            if (_tasks != null && left.Count > TaskItems)
            {
                StartTask(children, left, depth);
            }
            else
            {
                made += Split(children, left, depth);
            }

            slot = children + 1;
            range = right;
        }
    }

    private Task StartTask(int slot, in BvhRange range, int depth)
    {
        BvhRange own = range;
        return _tasks!.StartNew(() => Interlocked.Add(ref _nodeCount, Split(slot, own, depth)));
    }

    /// <summary>Divides a range in two, or tells that it is a leaf.</summary>
    private bool Divide(in BvhRange range, int depth, out BvhRange left, out BvhRange right, out int axis)
    {
        left = right = default;
        axis = 0;
        if (range.Count == 1)
        {
            return false;
        }

        // Halving ends after log2(count) levels: it takes over where the other way could become too deep.
        int levelsOfHalving = BitOperations.Log2((uint)range.Count) + 1;
        BvhSplit split = depth + levelsOfHalving < Bvh.MaximumDepth ? BvhSplit.Find(_references, range) : default;
        if (split.IsUseful)
        {
            float area = range.Box.HalfArea;
            if (range.Count <= _cost.MaximumLeaf && area + (_cost.ItemCost * split.Cost) >= _cost.ItemCost * range.Count * area)
            {
                return false;
            }

            axis = split.Axis;
            split.Partition(_references, range, out left, out right);
            return true;
        }

        if (range.Count <= _cost.MaximumLeaf)
        {
            return false;
        }

        BvhSplit.Halve(_references, range, out left, out right);
        return true;
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void Store(BvhNode* node, in BvhRange range)
    {
        *(Float4*)&node->MinX = -Float8.Lower(range.Box.Reach);
        *(Float4*)&node->MaxX = Float8.Upper(range.Box.Reach);
        node->First = range.First;
        node->Count = range.Count;
    }
}
