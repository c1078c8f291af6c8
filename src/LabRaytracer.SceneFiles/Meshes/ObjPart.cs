namespace LabRaytracer;

/// <summary>The triangles of an OBJ file that have the same material.</summary>
/// <param name="MaterialName">Name in the lines usemtl; empty for triangles before the first.</param>
/// <param name="Mesh">The triangles.</param>
/// <param name="Material">The material of the MTL files; null where they have none of this name.</param>
/// <remarks>Immutable, thread safe.</remarks>
public sealed record ObjPart(string MaterialName, TriangleMesh Mesh, Material? Material);
