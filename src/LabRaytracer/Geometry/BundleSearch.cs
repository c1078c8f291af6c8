using System.Runtime.CompilerServices;

namespace LabRaytracer;

/// <summary>Finds the objects that a bundle of rays may meet.</summary>
/// <remarks>Immutable, thread safe.</remarks>
[SkipLocalsInit]
internal sealed unsafe class BundleSearch
{
    /// <summary>Most objects that are worth a list: with more, single groups of lanes find theirs faster.</summary>
    public const int Most = 12;

    private readonly Bvh? _tree;
    private readonly Bounds[] _boxes;

    /// <param name="tree">The tree over the boxes, or null where they are few.</param>
    /// <param name="boxes">Boxes of the objects in the order of the tree's leaves; finite.</param>
    public BundleSearch(Bvh? tree, Bounds[] boxes)
    {
        _tree = tree;
        _boxes = boxes;
        Bounds all = boxes.Aggregate(Bounds.Empty, Bounds.Union);
        Size = boxes.Length == 0 ? 0 : Largest(all.Min.X, all.Max.X) + Largest(all.Min.Y, all.Max.Y) + Largest(all.Min.Z, all.Max.Z);
    }

    /// <summary>Sum of the largest coordinates, in magnitude.</summary>
    public double Size { get; }

    /// <summary>Lists the objects that any ray of a bundle may meet, by where that may be at the earliest.</summary>
    /// <param name="bundle">The rays.</param>
    /// <param name="candidates">Receives the objects; room for <see cref="Most"/>.</param>
    /// <returns>How many; -1 where they are too many.</returns>
    public int Find(in RayBundle bundle, BundleCandidate* candidates)
    {
        int count = 0;
        if (!bundle.IsUsable)
        {
            return -1;
        }

        return _tree == null ? AddAll(bundle, 0, _boxes.Length, candidates, ref count) : Descend(_tree, bundle, candidates);
    }

    private static double Largest(double min, double max) => Math.Max(Math.Abs(min), Math.Abs(max));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Bounds BoxOf(Bvh tree, in BvhNode node) => new(
        new Point3D(node.MinX + tree.Frame.CenterX, node.MinY + tree.Frame.CenterY, node.MinZ + tree.Frame.CenterZ),
        new Point3D(node.MaxX + tree.Frame.CenterX, node.MaxY + tree.Frame.CenterY, node.MaxZ + tree.Frame.CenterZ));

    /// <summary>Puts a candidate behind those that may come before it.</summary>
    private static void Insert(BundleCandidate* candidates, int count, BundleCandidate added)
    {
        int at = count;
        for (; at > 0 && candidates[at - 1].Start > added.Start; at--)
        {
            candidates[at] = candidates[at - 1];
        }

        candidates[at] = added;
    }

    private int Descend(Bvh tree, in RayBundle bundle, BundleCandidate* candidates)
    {
        int* pending = stackalloc int[Bvh.MaximumDepth + 2];
        int depth = 0, count = 0;
        pending[depth++] = 0;
        while (depth > 0)
        {
            BvhNode* node = tree.Nodes + pending[--depth];
            if (!bundle.Meets(BoxOf(tree, *node), out _))
            {
                continue;
            }

            if (node->Count <= 0)
            {
                pending[depth++] = node->First;
                pending[depth++] = node->First + 1;
            }
            else if (AddAll(bundle, node->First, node->First + node->Count, candidates, ref count) < 0)
            {
                return -1;
            }
        }

        return count;
    }

    /// <summary>Adds the objects at some places that the bundle may meet.</summary>
    private int AddAll(in RayBundle bundle, int first, int end, BundleCandidate* candidates, ref int count)
    {
        for (int place = first; place < end; place++)
        {
            if (bundle.Meets(_boxes[place], out double start))
            {
                if (count == Most)
                {
                    return -1;
                }

                Insert(candidates, count++, new BundleCandidate(place, start));
            }
        }

        return count;
    }
}
