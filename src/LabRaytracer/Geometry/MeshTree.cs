namespace LabRaytracer;

/// <summary>What finds the triangles of a mesh: the tree of boxes, and the triangles in the order of its leaves.</summary>
/// <remarks>Immutable, thread safe.</remarks>
internal sealed unsafe class MeshTree
{
    private const int Chunk = 16384;
    private readonly LaneMemory _memory = new();
    private readonly BvhWide? _boxes;

    /// <summary>Builds the tree of a mesh.</summary>
    /// <param name="mesh">The mesh.</param>
    /// <param name="kept">Numbers of the triangles that rays may hit; null for all.</param>
    /// <param name="bounds">The box of those triangles.</param>
    /// <param name="threads">Threads that may work on it, at least 1.</param>
    public MeshTree(MeshData mesh, int[]? kept, Bounds bounds, int threads)
    {
        using Bvh binary = Bvh.Build(new MeshItems(mesh, kept, bounds, threads), new BvhCost(ItemCost: 0.7f, MaximumLeaf: BvhWide.MostItems), threads, out int[] order);
        Frame = binary.Frame;
        if (binary.ItemCount == 0)
        {
            return;
        }

        _boxes = new BvhWide(binary);
        Triangles = _memory.Column<MeshTriangle>(binary.ItemCount, 1);
        MeshTriangle* triangles = Triangles;
        ChunkLoop.Run(binary.ItemCount, Chunk, threads, (first, end) =>
        {
            for (int i = first; i < end; i++)
            {
                int number = kept == null ? order[i] : kept[order[i]];
                int* corner = mesh.Corners + (3 * number);
                triangles[i] = new MeshTriangle(3 * corner[0], 3 * corner[1], 3 * corner[2], number);
            }
        });
    }

    /// <summary>Where the tree is.</summary>
    public BvhFrame Frame { get; }

    /// <summary>The nodes of the tree of boxes; null if there are no triangles.</summary>
    public BvhWideNode* Boxes => _boxes == null ? null : _boxes.Nodes;

    /// <summary>The triangles in the order of the leaves.</summary>
    public MeshTriangle* Triangles { get; }

    /// <summary>Prepares rays for the boxes; false if all are off.</summary>
    public bool Prepare<R, F, I>(in RayLanes<R> ray, in R limit, out BvhRay<R, F, I> boxRay)
        where R : unmanaged, ILane<R, F, I>
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I>
    {
        if (Boxes == null || !R.Any(R.Less(R.Zero, limit)))
        {
            boxRay = default;
            return false;
        }

        BvhRay<R, F, I>.Prepare(Frame, ray, limit, out boxRay);
        return boxRay.Active != 0;
    }

    /// <summary>Bytes of tree and triangles.</summary>
    public long Bytes => _memory.Bytes + (_boxes?.Bytes ?? 0);
}
