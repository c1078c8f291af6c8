namespace LabRaytracer;

/// <summary>What a <see cref="TriangleMesh"/> may have besides positions.</summary>
/// <remarks>Immutable, thread safe as long as the memory handed over is not changed before the mesh is made (the mesh copies it).</remarks>
public sealed class MeshOptions
{
    /// <summary>Normals for shading, object space, 3 finite numbers each, any length above 0 (OBJ: vn). Default: none, the mesh is flat.</summary>
    public ReadOnlyMemory<double> Normals { get; init; }

    /// <summary>The three normals of each triangle. Default, empty: the same numbers as the positions.</summary>
    public ReadOnlyMemory<int> NormalCorners { get; init; }

    /// <summary>Texture coordinates, 2 finite numbers each (OBJ: vt). Default: none.</summary>
    public ReadOnlyMemory<double> TextureCoordinates { get; init; }

    /// <summary>The three texture coordinates of each triangle. Default, empty: the same numbers as the positions.</summary>
    public ReadOnlyMemory<int> TextureCorners { get; init; }

    /// <summary>What happens to triangles without area. Default: <see cref="DegenerateTriangles.Reject"/>.</summary>
    public DegenerateTriangles DegenerateTriangles { get; init => field = PropertyChecks.Known(value); }
}
