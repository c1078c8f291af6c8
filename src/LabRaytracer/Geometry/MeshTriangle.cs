namespace LabRaytracer;

/// <summary>A triangle in the order of a tree's leaves: 16 bytes.</summary>
/// <param name="Element0">Where the coordinates of vertex 0 begin in the column of positions.</param>
/// <param name="Element1">The same for vertex 1.</param>
/// <param name="Element2">The same for vertex 2.</param>
/// <param name="Number">Number of the triangle in the mesh.</param>
internal readonly record struct MeshTriangle(int Element0, int Element1, int Element2, int Number);
