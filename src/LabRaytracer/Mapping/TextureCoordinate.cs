namespace LabRaytracer;

/// <summary>A point of texture space (Polish: współrzędne tekstury): u to the right, v up.</summary>
/// <param name="U">Horizontal coordinate; a picture covers [0, 1), its left edge is 0. Mappings of the sheet give [0, 1).</param>
/// <param name="V">Vertical coordinate, upward; a picture covers [0, 1], its bottom edge is 0.</param>
/// <remarks>Lab sheet IV, section 1.1: (u, v) in [0, 1] x [0, 1]. Immutable, thread safe.</remarks>
public readonly record struct TextureCoordinate(double U, double V);
