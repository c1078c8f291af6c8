using System.Runtime.InteropServices;

namespace LabRaytracer;

/// <summary>A tree of boxes with up to eight children a node, made of a binary one: for rays that go their own ways.</summary>
/// <remarks>Immutable, thread safe. Its leaves hold the items of the binary tree, in the same order.</remarks>
internal sealed unsafe class BvhWide
{
    /// <summary>Most items of a leaf; leaves of the binary tree must not have more.</summary>
    public const int MostItems = 4;

    private readonly LaneMemory _memory = new();

    /// <summary>Collapses a binary tree with at least one item.</summary>
    public BvhWide(Bvh tree)
    {
        using LaneMemory temporary = new();
        int* firstItem = temporary.Column<int>(tree.NodeCount, 1), itemCount = temporary.Column<int>(tree.NodeCount, 1);
        CountItems(tree, firstItem, itemCount);
        BvhCollapse collapse = new(tree, itemCount, temporary);
        List<BvhWideNode> nodes = new((tree.NodeCount / 16) + 1) { default };
        Stack<(int Binary, int Wide)> pending = [];
        pending.Push((0, 0));
        int* children = stackalloc int[BvhWideNode.Width];
        while (pending.TryPop(out (int Binary, int Wide) next))
        {
            int count = collapse.FindChildren(next.Binary, children);
            BvhWideNode node = Empty();
            for (int i = 0; i < count; i++)
            {
                int child = children[i];
                bool isLeaf = itemCount[child] <= MostItems;
                node.Children[i] = isLeaf ? ~((firstItem[child] << BvhWideNode.CountBits) | itemCount[child]) : nodes.Count;
                SetBox(ref node, i, tree.Nodes + child);
                if (!isLeaf)
                {
                    pending.Push((child, nodes.Count));
                    nodes.Add(default);
                }
            }

            nodes[next.Wide] = node;
        }

        Nodes = _memory.Column<BvhWideNode>(nodes.Count, 1);
        CollectionsMarshal.AsSpan(nodes).CopyTo(new Span<BvhWideNode>(Nodes, nodes.Count));
    }

    /// <summary>The nodes; 0 is the root.</summary>
    public BvhWideNode* Nodes { get; }

    /// <summary>Bytes of the nodes.</summary>
    public long Bytes => _memory.Bytes;

    /// <summary>First item and number of items below each node of a binary tree.</summary>
    private static void CountItems(Bvh tree, int* firstItem, int* itemCount)
    {
        for (int node = tree.NodeCount - 1; node >= 0; node--)
        {
            BvhNode* binary = tree.Nodes + node;
            bool isLeaf = binary->Count > 0;
            firstItem[node] = isLeaf ? binary->First : firstItem[binary->First];
            itemCount[node] = isLeaf ? binary->Count : itemCount[binary->First] + itemCount[binary->First + 1];
        }
    }

    private static BvhWideNode Empty()
    {
        BvhWideNode node = default;
        new Span<float>(node.Planes, 3 * BvhWideNode.Width).Fill(float.PositiveInfinity);
        new Span<float>(node.Planes + (3 * BvhWideNode.Width), 3 * BvhWideNode.Width).Fill(float.NegativeInfinity);
        return node;
    }

    private static void SetBox(ref BvhWideNode node, int child, BvhNode* box)
    {
        float* low = &box->MinX, high = &box->MaxX;
        for (int axis = 0; axis < 3; axis++)
        {
            node.Planes[(axis * BvhWideNode.Width) + child] = low[axis];
            node.Planes[((axis + 3) * BvhWideNode.Width) + child] = high[axis];
        }
    }
}
