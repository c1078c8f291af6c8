namespace LabRaytracer;

/// <summary>A direction drawn from a table of the sky.</summary>
/// <param name="Turns">Azimuth around +Y from +Z towards +X, turns, [0, 1].</param>
/// <param name="Cosine">Cosine of the angle to +Y.</param>
/// <param name="Weight">1 / (pi p) with the density p per steradian.</param>
internal readonly record struct EnvironmentSample(double Turns, double Cosine, double Weight);
