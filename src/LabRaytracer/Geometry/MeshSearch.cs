using System.Numerics;

namespace LabRaytracer;

/// <summary>Rays against a mesh, in its object space.</summary>
internal static unsafe class MeshSearch
{
    private const int FewRays = 2;

    /// <summary>Keeps the nearest hits of a group of lanes.</summary>
    public static void Nearest<R, F, I>(MeshData mesh, MeshTree tree, in RayLanes<R> ray, HitBatch<R, F, I> hits, int packet, int number)
        where R : unmanaged, ILane<R, F, I>
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I>
    {
        if (!Prepare(tree, ray, hits.T[packet], out BvhRay<R, F, I> boxRay))
        {
            return;
        }

        if (!AreTogether(boxRay))
        {
            MeshSingle.Nearest(mesh, tree, ray, boxRay, hits, packet, number);
            return;
        }

        MeshNearestSink<R, F, I> sink = new(hits, packet, number);
        Run(mesh, tree, ray, ref boxRay, ref sink);
    }

    /// <summary>Ends the rays of a group of lanes that are blocked: their limits become -1.</summary>
    /// <param name="mesh">The mesh.</param>
    /// <param name="tree">Its tree.</param>
    /// <param name="ray">The rays.</param>
    /// <param name="source">Numbers of the triangles that they leave, or -1.</param>
    /// <param name="limit">Their limits.</param>
    public static void Block<R, F, I>(MeshData mesh, MeshTree tree, in RayLanes<R> ray, in I source, ref R limit)
        where R : unmanaged, ILane<R, F, I>
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I>
    {
        if (!Prepare(tree, ray, limit, out BvhRay<R, F, I> boxRay))
        {
            return;
        }

        if (!AreTogether(boxRay))
        {
            MeshSingle.Block(mesh, tree, ray, boxRay, source, ref limit);
            return;
        }

        MeshBlockSink<R, F, I> sink = new(source);
        Run(mesh, tree, ray, ref boxRay, ref sink);
        limit = R.Select(sink.Blocked, R.Of(-1), limit);
    }

    /// <summary>Prepares rays for the tree of a mesh; false if all are off.</summary>
    public static bool Prepare<R, F, I>(MeshTree tree, in RayLanes<R> ray, in R limit, out BvhRay<R, F, I> boxRay)
        where R : unmanaged, ILane<R, F, I>
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I>
    {
        if (tree.Boxes == null || !R.Any(R.Less(R.Zero, limit)))
        {
            boxRay = default;
            return false;
        }

        BvhRay<R, F, I>.Prepare(tree.Frame, ray, limit, out boxRay);
        return boxRay.Active != 0;
    }

    /// <summary>Tells whether prepared rays are better off together: they are several and share the signs of their directions.</summary>
    private static bool AreTogether<R, F, I>(in BvhRay<R, F, I> boxRay)
        where R : unmanaged, ILane<R, F, I>
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I> => boxRay.SharesSigns && BitOperations.PopCount(boxRay.Active) > FewRays;

    /// <summary>Hands the hits with 0 &lt; t &lt;= limit to a sink, which lowers the limit; all lanes together.</summary>
    private static void Run<R, F, I, TSink>(MeshData mesh, MeshTree tree, in RayLanes<R> ray, ref BvhRay<R, F, I> boxRay, ref TSink sink)
        where R : unmanaged, ILane<R, F, I>
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I>
        where TSink : struct, IMeshSink<R>
    {
        if (mesh.Positions.Singles != null)
        {
            Run<R, F, I, MeshSinglePositions, TSink>(new MeshSinglePositions(mesh.Positions.Singles), tree, ray, ref boxRay, ref sink);
        }
        else
        {
            Run<R, F, I, MeshDoublePositions, TSink>(new MeshDoublePositions(mesh.Positions.Doubles), tree, ray, ref boxRay, ref sink);
        }
    }

    private static void Run<R, F, I, P, TSink>(P positions, MeshTree tree, in RayLanes<R> ray, ref BvhRay<R, F, I> boxRay, ref TSink sink)
        where R : unmanaged, ILane<R, F, I>
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I>
        where P : struct, IMeshPositions
        where TSink : struct, IMeshSink<R>
    {
        BvhBundle.Bound(tree.Frame, ray, boxRay, out BvhBundle bundle);
        fixed (BvhRay<R, F, I>* rays = &boxRay)
        {
            MeshLeaf<R, F, I, P, TSink> triangles = new(tree.Triangles, positions, ray, R.Less(R.Zero, boxRay.Limit), sink);
            BvhBundleLeaf<R, F, I, MeshLeaf<R, F, I, P, TSink>> leaf = new(rays, triangles);
            BvhWideTraversal.Run(tree.Boxes, ref bundle, leaf.LargestLimit, ref leaf);
            sink = leaf.Items.Sink;
        }
    }
}
