namespace LabRaytracer;

/// <summary>Rays against a mesh, in its object space.</summary>
internal static unsafe class MeshSearch
{
    /// <summary>Hands the hits with 0 &lt; t &lt;= limit to a sink, which lowers the limit; all lanes together.</summary>
    public static void Run<R, F, I, TSink>(MeshData mesh, MeshTree tree, in RayLanes<R> ray, in R limit, ref TSink sink)
        where R : unmanaged, ILane<R, F, I>
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I>
        where TSink : struct, IMeshSink<R>
    {
        if (Prepare<R, F, I>(tree, ray, limit, out BvhRay<R, F, I> boxRay))
        {
            Run<R, F, I, TSink>(mesh, tree, ray, boxRay, ref sink);
        }
    }

    /// <summary>Prepares rays for the tree of a mesh; false if all are off.</summary>
    public static bool Prepare<R, F, I>(MeshTree tree, in RayLanes<R> ray, in R limit, out BvhRay<R, F, I> boxRay)
        where R : unmanaged, ILane<R, F, I>
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I>
    {
        if (tree.Boxes.ItemCount == 0 || !R.Any(R.Less(R.Zero, limit)))
        {
            boxRay = default;
            return false;
        }

        BvhRay<R, F, I>.Prepare(tree.Boxes, ray, limit, out boxRay);
        return boxRay.Active != 0;
    }

    /// <summary>The same for prepared rays.</summary>
    public static void Run<R, F, I, TSink>(MeshData mesh, MeshTree tree, in RayLanes<R> ray, in BvhRay<R, F, I> boxRay, ref TSink sink)
        where R : unmanaged, ILane<R, F, I>
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I>
        where TSink : struct, IMeshSink<R>
    {
        if (mesh.Positions.Singles != null)
        {
            Run<R, F, I, MeshSinglePositions, TSink>(new MeshSinglePositions(mesh.Positions.Singles), tree, ray, boxRay, ref sink);
        }
        else
        {
            Run<R, F, I, MeshDoublePositions, TSink>(new MeshDoublePositions(mesh.Positions.Doubles), tree, ray, boxRay, ref sink);
        }
    }

    private static void Run<R, F, I, P, TSink>(P positions, MeshTree tree, in RayLanes<R> ray, in BvhRay<R, F, I> boxRay, ref TSink sink)
        where R : unmanaged, ILane<R, F, I>
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I>
        where P : struct, IMeshPositions
        where TSink : struct, IMeshSink<R>
    {
        MeshLeaf<R, F, I, P, TSink> leaf = new(tree.Triangles, positions, ray, R.Less(R.Zero, boxRay.Limit), sink);
        BvhTraversal.Run<R, F, I, MeshLeaf<R, F, I, P, TSink>>(tree.Boxes, boxRay, ref leaf);
        sink = leaf.Sink;
    }
}
