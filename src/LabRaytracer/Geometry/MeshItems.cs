namespace LabRaytracer;

/// <summary>The triangles of a mesh as the items of a tree: each vertex is rounded once, not once for each triangle at it.</summary>
internal readonly unsafe struct MeshItems : IBvhItems
{
    private const int Chunk = 16384;
    private readonly MeshData _mesh;
    private readonly int[]? _kept;
    private readonly LaneMemory _memory = new();
    private readonly Float8* _vertices;
    private readonly int _threads;

    /// <param name="mesh">The mesh.</param>
    /// <param name="kept">Numbers of the triangles that take part; null for all.</param>
    /// <param name="bounds">Their box.</param>
    /// <param name="threads">Threads that may work, at least 1.</param>
    public MeshItems(MeshData mesh, int[]? kept, Bounds bounds, int threads)
    {
        _mesh = mesh;
        _kept = kept;
        _threads = threads;
        All = bounds;
        _vertices = _memory.Column<Float8>(8 * mesh.VertexCount, 8);
    }

    public int Count => _kept == null ? _mesh.TriangleCount : _kept.Length;

    public Bounds All { get; }

    public void Prepare(Point3D center)
    {
        MeshData mesh = _mesh;
        Float8* vertices = _vertices;
        ChunkLoop.Run(mesh.VertexCount, Chunk, _threads, (first, end) =>
        {
            for (int vertex = first; vertex < end; vertex++)
            {
                vertices[vertex] = BvhReach.Of(mesh.Position(vertex), center);
            }
        });
    }

    public void Release() => _memory.Dispose();

    public void Describe(Point3D center, BvhReference* references, int first, int end)
    {
        for (int item = first; item < end; item++)
        {
            int* corner = _mesh.Corners + (3 * (_kept == null ? item : _kept[item]));
            references[item].Set(Float8.Max(Float8.Max(_vertices[corner[0]], _vertices[corner[1]]), _vertices[corner[2]]), item);
        }
    }
}
