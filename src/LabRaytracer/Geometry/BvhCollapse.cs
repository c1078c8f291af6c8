namespace LabRaytracer;

/// <summary>Which nodes of a binary tree become nodes with up to eight children, so that the boxes of all of them are smallest in sum: rays meet nodes as often as these are large.</summary>
/// <remarks>
/// What a subtree costs in k places of a parent is least over how many of them its left child gets; in one place it is a node of its own, which has eight.
/// Ylitie, Karras, Laine, "Efficient incoherent ray traversal on GPUs through compressed wide BVHs", High-Performance Graphics, 2017, section 3.1.
/// </remarks>
internal readonly unsafe struct BvhCollapse
{
    private const int Width = BvhWideNode.Width;
    private readonly BvhNode* _nodes;
    private readonly int* _itemCount;

    /// <summary>Costs in 1 to 8 places, node after node.</summary>
    private readonly float* _costs;

    /// <summary>Finds the costs of a tree.</summary>
    /// <param name="tree">The tree.</param>
    /// <param name="itemCount">Number of items below each of its nodes.</param>
    /// <param name="memory">Owns the costs.</param>
    public BvhCollapse(Bvh tree, int* itemCount, LaneMemory memory)
    {
        _nodes = tree.Nodes;
        _itemCount = itemCount;
        _costs = memory.Column<float>(Width * tree.NodeCount, 1);
        for (int node = tree.NodeCount - 1; node >= 0; node--)
        {
            if (!IsLeaf(node) && node != 1)
            {
                Measure(node);
            }
        }
    }

    /// <summary>Finds the children of a wide node.</summary>
    /// <param name="node">The binary node that it is made of.</param>
    /// <param name="children">Receives binary nodes that together hold its items; room for eight.</param>
    /// <returns>How many.</returns>
    public int FindChildren(int node, int* children)
    {
        int count = 0;
        if (IsLeaf(node))
        {
            children[count++] = node;
        }
        else
        {
            Open(node, Width, children, ref count);
        }

        return count;
    }

    /// <summary>Tells whether the items below a node become one leaf.</summary>
    private bool IsLeaf(int node) => _itemCount[node] <= BvhWide.MostItems;

    /// <summary>The costs of a node whose children's are known.</summary>
    private void Measure(int node)
    {
        float* own = _costs + (Width * node), left = _costs + (Width * _nodes[node].First), right = left + Width;
        for (int places = 2; places <= Width; places++)
        {
            float least = float.PositiveInfinity;
            for (int first = 1; first < places; first++)
            {
                least = Math.Min(least, left[first - 1] + right[places - first - 1]);
            }

            own[places - 1] = least;
        }

        own[0] = HalfArea(_nodes + node) + own[Width - 1];
        for (int places = 2; places <= Width; places++)
        {
            own[places - 1] = Math.Min(own[places - 1], own[0]);
        }
    }

    /// <summary>Puts the children of a node into a number of places.</summary>
    private void Open(int node, int places, int* children, ref int count)
    {
        int left = _nodes[node].First;
        float* costs = _costs + (Width * left);
        int best = 1;
        float least = float.PositiveInfinity;
        for (int first = 1; first < places; first++)
        {
            float cost = costs[first - 1] + costs[Width + places - first - 1];
            (best, least) = cost < least ? (first, cost) : (best, least);
        }

        Place(left, best, children, ref count);
        Place(left + 1, places - best, children, ref count);
    }

    /// <summary>Puts a node into a number of places: as it is, or its children.</summary>
    private void Place(int node, int places, int* children, ref int count)
    {
        float* costs = _costs + (Width * node);
        if (IsLeaf(node) || places == 1 || costs[0] <= costs[places - 1])
        {
            children[count++] = node;
        }
        else
        {
            Open(node, places, children, ref count);
        }
    }

    private static float HalfArea(BvhNode* node)
    {
        float x = node->MaxX - node->MinX, y = node->MaxY - node->MinY, z = node->MaxZ - node->MinZ;
        return (x * y) + (y * z) + (z * x);
    }
}
