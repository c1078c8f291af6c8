using System.Numerics;

namespace LabRaytracer;

/// <summary>What finds the triangles of a mesh: the tree of boxes, and the triangles in the order of its leaves.</summary>
/// <remarks>Immutable, thread safe.</remarks>
internal sealed unsafe class MeshTree
{
    private const int Chunk = 16384;

    // A picture has some groups of rays that part at an axis; only many of them are worth the wide tree.
    private const int PartedGroups = 256;
    private const int FewRays = 2;
    private readonly LaneMemory _memory = new();
    private readonly Lock _collapsing = new();
    private volatile BvhWide? _wide;
    private int _parted;

    /// <summary>Builds the tree of a mesh.</summary>
    /// <param name="mesh">The mesh.</param>
    /// <param name="kept">Numbers of the triangles that rays may hit; null for all.</param>
    /// <param name="bounds">The box of those triangles.</param>
    /// <param name="threads">Threads that may work on it, at least 1.</param>
    public MeshTree(MeshData mesh, int[]? kept, Bounds bounds, int threads)
    {
        using LaneMemory temporary = new();
        Boxes = Bvh.Build(new MeshItems(mesh, kept, bounds, temporary, threads), new BvhCost(ItemCost: 0.7f, MaximumLeaf: 4), threads, out int[] order);
        Triangles = _memory.Column<MeshTriangle>(Boxes.ItemCount, 1);
        MeshTriangle* triangles = Triangles;
        ChunkLoop.Run(Boxes.ItemCount, Chunk, threads, (first, end) =>
        {
            for (int i = first; i < end; i++)
            {
                int number = kept == null ? order[i] : kept[order[i]];
                int* corner = mesh.Corners + (3 * number);
                triangles[i] = new MeshTriangle(3 * corner[0], 3 * corner[1], 3 * corner[2], number);
            }
        });
    }

    /// <summary>The tree of boxes.</summary>
    public Bvh Boxes { get; }

    /// <summary>The triangles in the order of the leaves.</summary>
    public MeshTriangle* Triangles { get; }

    /// <summary>Bytes of trees and triangles.</summary>
    public long Bytes => _memory.Bytes + Boxes.Bytes + (_wide?.Bytes ?? 0);

    /// <summary>The tree for one ray at a time, if these rays are better off with it: they are few, or part (their directions differ in signs). Null if not.</summary>
    /// <remarks>It is made when enough groups of rays have parted, by the thread that counts the last of them; the others go on without.</remarks>
    public BvhWide? WideFor<R, F, I>(in BvhRay<R, F, I> rays)
        where R : unmanaged, ILane<R, F, I>
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I>
    {
        if (R.Width == 1)
        {
            return null;
        }

        if (rays.SharesSigns)
        {
            return BitOperations.PopCount(rays.Active) <= FewRays ? _wide : null;
        }

        return _wide ?? CountParted();
    }

    private BvhWide? CountParted()
    {
        // A count that is lost between threads only delays.
        if (++_parted < PartedGroups || !_collapsing.TryEnter())
        {
            return null;
        }

        try
        {
            return _wide ??= new BvhWide(Boxes);
        }
        finally
        {
            _collapsing.Exit();
        }
    }
}
