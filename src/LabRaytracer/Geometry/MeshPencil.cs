using System.Runtime.CompilerServices;

namespace LabRaytracer;

/// <summary>Pencils of rays against a mesh, in its object space.</summary>
/// <remarks>The same hits as <see cref="MeshCrowd"/>, bit for bit: what floats leave open is decided by the same test.</remarks>
internal static unsafe class MeshPencil
{
    /// <summary>Fewer rays are no pencil.</summary>
    public const int FewestRays = 4;

    /// <summary>Groups of lanes that are searched for together at most: many share what is done for boxes and triangles, but differ in where they go.</summary>
    public const int MostPackets = 16;

    /// <summary>Keeps the nearest hits, if the rays are a pencil that starts in its apex.</summary>
    /// <param name="mesh">The mesh.</param>
    /// <param name="tree">Its tree.</param>
    /// <param name="lanes">Groups of lanes with their rays and limits.</param>
    /// <param name="count">How many groups.</param>
    /// <param name="hits">Receives the hits.</param>
    /// <param name="first">The first group of lanes there.</param>
    /// <param name="number">Number of the mesh's object.</param>
    [SkipLocalsInit]
    public static PencilAnswer Nearest<R, F, I>(MeshData mesh, MeshTree tree, PencilLanes<R, F, I>* lanes, int count, HitBatch<R, F, I> hits, int first, int number)
        where R : unmanaged, ILane<R, F, I>
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I>
    {
        SlopeBounds* slopes = stackalloc SlopeBounds[count];
        if (R.Width < PencilTriangles.Most || tree.Boxes == null || !PencilFinder.Find(lanes, count, tree.Frame, endsAtApex: false, slopes, out RayPencil pencil))
        {
            return PencilAnswer.NoPencil;
        }

        return Run(mesh, tree, pencil, lanes, count, slopes, new PencilNearest<R, F, I>(mesh, tree.Triangles, pencil.Axis, hits, first, number));
    }

    /// <summary>Ends the rays that are blocked, if they are a pencil that ends in its apex.</summary>
    /// <param name="mesh">The mesh.</param>
    /// <param name="tree">Its tree.</param>
    /// <param name="lanes">Groups of lanes with their rays and limits.</param>
    /// <param name="count">How many groups.</param>
    /// <param name="rays">The rays; limits of blocked ones become -1.</param>
    /// <param name="first">The first group of lanes there.</param>
    /// <param name="number">Number of the mesh's object.</param>
    [SkipLocalsInit]
    public static PencilAnswer Block<R, F, I>(MeshData mesh, MeshTree tree, PencilLanes<R, F, I>* lanes, int count, RayBatch<R, F, I> rays, int first, int number)
        where R : unmanaged, ILane<R, F, I>
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I>
    {
        SlopeBounds* slopes = stackalloc SlopeBounds[count];
        if (R.Width < PencilTriangles.Most || tree.Boxes == null || !PencilFinder.Find(lanes, count, tree.Frame, endsAtApex: true, slopes, out RayPencil pencil))
        {
            return PencilAnswer.NoPencil;
        }

        return Run(mesh, tree, pencil, lanes, count, slopes, new PencilBlock<R, F, I>(mesh, tree.Triangles, pencil.Axis, rays, first, number));
    }

    private static PencilAnswer Run<R, F, I, TGoal>(MeshData mesh, MeshTree tree, in RayPencil pencil, PencilLanes<R, F, I>* lanes, int count, SlopeBounds* slopes, in TGoal goal)
        where R : unmanaged, ILane<R, F, I>
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I>
        where TGoal : struct, IPencilGoal<R, F, I>
    {
        if (mesh.Positions.Singles != null)
        {
            return Run(new MeshSinglePositions(mesh.Positions.Singles), tree, pencil, lanes, count, slopes, goal);
        }

        return R.IsSingle
            ? Run(new MeshRoundedPositions(mesh.Positions.Doubles), tree, pencil, lanes, count, slopes, goal)
            : Run(new MeshDoublePositions(mesh.Positions.Doubles), tree, pencil, lanes, count, slopes, goal);
    }

    [SkipLocalsInit]
    private static PencilAnswer Run<R, F, I, P, TGoal>(P positions, MeshTree tree, in RayPencil pencil, PencilLanes<R, F, I>* lanes, int count, SlopeBounds* slopes, in TGoal goal)
        where R : unmanaged, ILane<R, F, I>
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I>
        where P : struct, IMeshPositions
        where TGoal : struct, IPencilGoal<R, F, I>
    {
        byte* triangleRoom = stackalloc byte[((PencilTriangles.Numbers + PencilTriangles.VertexNumbers) * PencilTriangles.Room * sizeof(float)) + CacheLine.Bytes];
        float* columns = (float*)CacheLine.Start(triangleRoom), vertices = columns + (PencilTriangles.Numbers * PencilTriangles.Room);
        Unsafe.SkipInit(out PencilQueue queue);
        queue.Clear();
        byte* room = stackalloc byte[PencilParts<F, I>.Bytes + CacheLine.Bytes];
        PencilParts<F, I> parts = new(pencil, tree.Frame, slopes, count, (float*)CacheLine.Start(room));
        PencilLeaf<R, F, I, P, TGoal> leaf = new(pencil, lanes, count, tree.Triangles, positions, vertices, columns, &queue, parts, goal);
        float limit = leaf.Start();
        PencilBoxes boxes = new(pencil, tree.Frame);
        if (TGoal.IsOrdered)
        {
            BvhWideTraversal.Run(tree.Boxes, ref boxes, limit, ref leaf);
        }
        else
        {
            PencilTraversal.Run(tree.Boxes, boxes, limit, ref leaf);
        }

        leaf.End();
        return leaf.IsTooWide ? PencilAnswer.TooWide : PencilAnswer.Found;
    }
}
