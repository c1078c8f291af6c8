namespace LabRaytracer;

/// <summary>The numbers of a mesh, outside the garbage collector's reach.</summary>
/// <remarks>Immutable, thread safe.</remarks>
internal sealed unsafe class MeshData
{
    private readonly LaneMemory _memory = new();

    public MeshData(ReadOnlySpan<double> positions, ReadOnlySpan<int> corners, MeshOptions options)
    {
        VertexCount = positions.Length / 3;
        TriangleCount = corners.Length / 3;
        Positions = new MeshColumn(_memory, positions);
        Corners = Copy(corners);
        if (!options.Normals.IsEmpty)
        {
            Normals = new MeshColumn(_memory, options.Normals.Span);
            NormalCorners = CornersOf(corners, options.NormalCorners.Span);
        }

        if (!options.TextureCoordinates.IsEmpty)
        {
            TextureCoordinates = new MeshColumn(_memory, options.TextureCoordinates.Span);
            TextureCorners = CornersOf(corners, options.TextureCorners.Span);
        }
    }

    /// <summary>Number of vertex positions.</summary>
    public int VertexCount { get; }

    /// <summary>Number of triangles.</summary>
    public int TriangleCount { get; }

    /// <summary>Bytes that the numbers take.</summary>
    public long Bytes => _memory.Bytes;

    /// <summary>3 coordinates a vertex.</summary>
    public MeshColumn Positions { get; }

    /// <summary>3 coordinates a normal, if there are any.</summary>
    public MeshColumn Normals { get; }

    /// <summary>2 coordinates a texture coordinate, if there are any.</summary>
    public MeshColumn TextureCoordinates { get; }

    /// <summary>3 vertex numbers a triangle.</summary>
    public int* Corners { get; }

    /// <summary>3 normal numbers a triangle; the same memory as <see cref="Corners"/> where the numbers are the same.</summary>
    public int* NormalCorners { get; }

    /// <summary>3 texture coordinate numbers a triangle; the same memory as <see cref="Corners"/> where the numbers are the same.</summary>
    public int* TextureCorners { get; }

    /// <summary>A vertex position.</summary>
    public Point3D Position(int vertex) => new(Positions[3 * vertex], Positions[(3 * vertex) + 1], Positions[(3 * vertex) + 2]);

    /// <summary>The position of one of a triangle's three corners.</summary>
    public Point3D Position(int triangle, int corner) => Position(Corners[(3 * triangle) + corner]);

    /// <summary>A box that grows to hold a triangle.</summary>
    public Bounds BoundsOf(int triangle, in Bounds box) => box.Including(Position(triangle, 0)).Including(Position(triangle, 1)).Including(Position(triangle, 2));

    private int* CornersOf(ReadOnlySpan<int> corners, ReadOnlySpan<int> own) => own.IsEmpty || own.SequenceEqual(corners) ? Corners : Copy(own);

    private int* Copy(ReadOnlySpan<int> numbers)
    {
        int* copy = _memory.Column<int>(numbers.Length, 1);
        numbers.CopyTo(new Span<int>(copy, numbers.Length));
        return copy;
    }
}
