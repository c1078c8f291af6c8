namespace LabRaytracer;

/// <summary>The coefficients of a material at one point, textures applied: k' of lab sheet IV, section 1.1.</summary>
/// <param name="Diffuse">k_d.</param>
/// <param name="Specular">k_s.</param>
/// <param name="Shininess">Specular exponent, at least 0.</param>
/// <remarks>Immutable, thread safe.</remarks>
public readonly record struct SurfaceValues(Intensity Diffuse, Intensity Specular, float Shininess);
