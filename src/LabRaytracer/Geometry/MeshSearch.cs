namespace LabRaytracer;

/// <summary>Rays against a mesh, in its object space.</summary>
internal static unsafe class MeshSearch
{
    /// <summary>Hands the hits with 0 &lt; t &lt;= limit to a sink, which lowers the limit.</summary>
    public static void Run<R, F, I, TSink>(MeshData mesh, MeshTree tree, in RayLanes<R> ray, in R limit, ref TSink sink)
        where R : unmanaged, ILane<R, F, I>
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I>
        where TSink : struct, IMeshSink<R>
    {
        if (!R.Any(R.Less(R.Zero, limit)))
        {
            return;
        }

        if (mesh.Positions.Singles != null)
        {
            Run<R, F, I, MeshSinglePositions, TSink>(new MeshSinglePositions(mesh.Positions.Singles), tree, ray, limit, ref sink);
        }
        else
        {
            Run<R, F, I, MeshDoublePositions, TSink>(new MeshDoublePositions(mesh.Positions.Doubles), tree, ray, limit, ref sink);
        }
    }

    private static void Run<R, F, I, P, TSink>(P positions, MeshTree tree, in RayLanes<R> ray, in R limit, ref TSink sink)
        where R : unmanaged, ILane<R, F, I>
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I>
        where P : struct, IMeshPositions
        where TSink : struct, IMeshSink<R>
    {
        MeshLeaf<R, F, I, P, TSink> leaf = new(tree.Triangles, positions, ray, R.Less(R.Zero, limit), sink);
        BvhTraversal.Run<R, F, I, MeshLeaf<R, F, I, P, TSink>>(tree.Boxes, ray, limit, ref leaf);
        sink = leaf.Sink;
    }
}
