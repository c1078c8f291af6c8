using System.Runtime.CompilerServices;

namespace LabRaytracer;

/// <summary>Pencils of rays against a mesh, in its object space.</summary>
/// <remarks>The same hits as <see cref="MeshSearch"/>, bit for bit: what floats leave open is decided by the same test.</remarks>
internal static unsafe class MeshPencil
{
    /// <summary>Fewer rays are no pencil.</summary>
    public const int FewestRays = 4;

    /// <summary>Rays that are searched for together.</summary>
    private const int RaysTogether = 64;

    /// <summary>Groups of lanes that are searched for together.</summary>
    public static int PacketsOf<R>()
        where R : unmanaged, IReal<R> => Math.Max(1, RaysTogether / R.Width);

    /// <summary>Keeps the nearest hits, if the rays are a pencil that starts in its apex; else false, and nothing happens.</summary>
    /// <param name="mesh">The mesh.</param>
    /// <param name="tree">Its tree.</param>
    /// <param name="lanes">Groups of lanes with their rays and limits.</param>
    /// <param name="count">How many groups.</param>
    /// <param name="hits">Receives the hits.</param>
    /// <param name="first">The first group of lanes there.</param>
    /// <param name="number">Number of the mesh's object.</param>
    [SkipLocalsInit]
    public static bool Nearest<R, F, I>(MeshData mesh, MeshTree tree, PencilLanes<R, F, I>* lanes, int count, HitBatch<R, F, I> hits, int first, int number)
        where R : unmanaged, ILane<R, F, I>
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I>
    {
        F* parts = stackalloc F[PencilParts.Room<F>(count)];
        if (tree.Boxes == null || !PencilFinder.Find(lanes, count, tree.Frame, endsAtApex: false, parts, out RayPencil pencil))
        {
            return false;
        }

        Run(mesh, tree, pencil, lanes, count, parts, new PencilNearest<R, F, I>(mesh, tree.Triangles, hits, first, number));
        return true;
    }

    /// <summary>Ends the rays that are blocked, if they are a pencil that ends in its apex; else false, and nothing happens.</summary>
    /// <param name="mesh">The mesh.</param>
    /// <param name="tree">Its tree.</param>
    /// <param name="lanes">Groups of lanes with their rays and limits.</param>
    /// <param name="count">How many groups.</param>
    /// <param name="rays">The rays; limits of blocked ones become -1.</param>
    /// <param name="first">The first group of lanes there.</param>
    /// <param name="number">Number of the mesh's object.</param>
    [SkipLocalsInit]
    public static bool Block<R, F, I>(MeshData mesh, MeshTree tree, PencilLanes<R, F, I>* lanes, int count, RayBatch<R, F, I> rays, int first, int number)
        where R : unmanaged, ILane<R, F, I>
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I>
    {
        F* parts = stackalloc F[PencilParts.Room<F>(count)];
        if (tree.Boxes == null || !PencilFinder.Find(lanes, count, tree.Frame, endsAtApex: true, parts, out RayPencil pencil))
        {
            return false;
        }

        Run(mesh, tree, pencil, lanes, count, parts, new PencilBlock<R, F, I>(mesh, tree.Triangles, rays, first, number));
        return true;
    }

    private static void Run<R, F, I, TGoal>(MeshData mesh, MeshTree tree, in RayPencil pencil, PencilLanes<R, F, I>* lanes, int count, F* parts, in TGoal goal)
        where R : unmanaged, ILane<R, F, I>
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I>
        where TGoal : struct, IPencilGoal<R, F, I>
    {
        if (mesh.Positions.Singles != null)
        {
            Run(new MeshSinglePositions(mesh.Positions.Singles), tree, pencil, lanes, count, parts, goal);
        }
        else if (R.IsSingle)
        {
            Run(new MeshRoundedPositions(mesh.Positions.Doubles), tree, pencil, lanes, count, parts, goal);
        }
        else
        {
            Run(new MeshDoublePositions(mesh.Positions.Doubles), tree, pencil, lanes, count, parts, goal);
        }
    }

    [SkipLocalsInit]
    private static void Run<R, F, I, P, TGoal>(P positions, MeshTree tree, in RayPencil pencil, PencilLanes<R, F, I>* lanes, int count, F* parts, in TGoal goal)
        where R : unmanaged, ILane<R, F, I>
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I>
        where P : struct, IMeshPositions
        where TGoal : struct, IPencilGoal<R, F, I>
    {
        float* columns = stackalloc float[PencilTriangles.Numbers * PencilTriangles.Most];
        PencilLeaf<R, F, I, P, TGoal> leaf = new(pencil, lanes, count, tree.Triangles, positions, columns, parts, goal);
        float limit = leaf.Start();
        PencilBoxes boxes = new(pencil, tree.Frame);
        BvhWideTraversal.Run(tree.Boxes, ref boxes, limit, ref leaf);
        leaf.End();
    }
}
