namespace LabRaytracer;

/// <summary>What a mesh does with triangles that have no area.</summary>
public enum DegenerateTriangles
{
    /// <summary>The constructor throws and names the first one. The default.</summary>
    Reject,

    /// <summary>No ray hits them; all triangles keep their numbers.</summary>
    Drop,
}
