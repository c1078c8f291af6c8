namespace LabRaytracer;

/// <summary>The light of one lamp that arrives at a point if nothing is in its way.</summary>
/// <param name="Direction">Towards the lamp, world space, length 1.</param>
/// <param name="Distance">Distance of the lamp, scene units, above 0; infinite for directional light.</param>
/// <param name="Intensity">Light that arrives, attenuation included, linear.</param>
/// <remarks>Immutable, thread safe.</remarks>
public readonly record struct LightSample(Vector3D Direction, double Distance, Intensity Intensity);
