namespace LabRaytracer;

/// <summary>How fast texture coordinates change with the local point: the gradients of u and v.</summary>
/// <param name="U">Gradient of u, object space (world space for mappings whose frame is the world), texture units a unit of the point.</param>
/// <param name="V">Gradient of v, in the same space.</param>
/// <remarks>
/// A small step d of the local point changes u by U . d and v by V . d. The tangents of a surface along u and v follow from them; for a sphere they point east and north.
/// Immutable, thread safe.
/// </remarks>
public readonly record struct MappingGradient(Vector3D U, Vector3D V)
{
    /// <summary>The change of (u, v) over two steps of the local point.</summary>
    /// <param name="stepX">Step of the local point over one pixel to the right, object space.</param>
    /// <param name="stepY">Step of the local point over one pixel down, object space.</param>
    public TextureFootprint Over(Vector3D stepX, Vector3D stepY) =>
        new(Vector3D.Dot(U, stepX), Vector3D.Dot(V, stepX), Vector3D.Dot(U, stepY), Vector3D.Dot(V, stepY));
}
