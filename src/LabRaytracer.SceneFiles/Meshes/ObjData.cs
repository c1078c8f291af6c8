namespace LabRaytracer;

/// <summary>The numbers of an OBJ file, all triangles in the order of the file.</summary>
/// <remarks>Indices start at 0; -1 stands for none.</remarks>
internal sealed class ObjData(ObjCounts counts)
{
    /// <summary>How many there are of each.</summary>
    public ObjCounts Counts => counts;

    /// <summary>Three numbers a vertex.</summary>
    public double[] Positions { get; } = GC.AllocateUninitializedArray<double>(checked(3 * counts.Positions));

    /// <summary>Two numbers a texture coordinate.</summary>
    public double[] Uvs { get; } = GC.AllocateUninitializedArray<double>(checked(2 * counts.Uvs));

    /// <summary>Three numbers a normal.</summary>
    public double[] Normals { get; } = GC.AllocateUninitializedArray<double>(checked(3 * counts.Normals));

    /// <summary>Three indices of positions for each triangle.</summary>
    public int[] PositionOf { get; } = GC.AllocateUninitializedArray<int>(checked(3 * counts.Triangles));

    /// <summary>Three indices of texture coordinates for each triangle; empty if the file has none.</summary>
    public int[] UvOf { get; } = counts.Uvs == 0 ? [] : GC.AllocateUninitializedArray<int>(3 * counts.Triangles);

    /// <summary>Three indices of normals for each triangle; empty if the file has none.</summary>
    public int[] NormalOf { get; } = counts.Normals == 0 ? [] : GC.AllocateUninitializedArray<int>(3 * counts.Triangles);

    /// <summary>A vertex.</summary>
    public Point3D Position(int index) => new(Positions[3 * index], Positions[(3 * index) + 1], Positions[(3 * index) + 2]);

    /// <summary>Sets a corner.</summary>
    /// <param name="at">Three times the triangle, plus 0, 1 or 2.</param>
    /// <param name="corner">Its indices.</param>
    public void SetCorner(int at, ObjCorner corner)
    {
        PositionOf[at] = corner.Position;
        if (UvOf.Length > 0)
        {
            UvOf[at] = corner.Uv;
        }

        if (NormalOf.Length > 0)
        {
            NormalOf[at] = corner.Normal;
        }
    }

    /// <summary>The indices of a corner.</summary>
    public ObjCorner GetCorner(int at) => new(PositionOf[at], UvOf.Length > 0 ? UvOf[at] : -1, NormalOf.Length > 0 ? NormalOf[at] : -1);
}

/// <summary>A corner of a face: indices from 0, -1 for none.</summary>
internal readonly record struct ObjCorner(int Position, int Uv, int Normal);
