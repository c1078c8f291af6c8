namespace LabRaytracer;

/// <summary>Where a ray meets a shape, as the shape itself describes it.</summary>
/// <param name="T">Ray parameter, in lengths of the ray's direction, above 0.</param>
/// <param name="Part">Number of the shape's part that was hit (a mesh's triangle); 0 for shapes of one part.</param>
/// <param name="A">First coordinate inside the part (a triangle's weight of its second vertex), meaning chosen by the shape.</param>
/// <param name="B">Second coordinate inside the part (a triangle's weight of its third vertex).</param>
/// <remarks>Immutable, thread safe.</remarks>
public readonly record struct Hit(double T, int Part = 0, double A = 0, double B = 0);
