namespace LabRaytracer;

/// <summary>A reflected or refracted ray that waits for its turn.</summary>
/// <param name="Ray">The ray, world space, direction of length 1.</param>
/// <param name="Weight">Share of its light that reaches the pixel.</param>
/// <param name="Pixel">Number of the pixel in the tile.</param>
internal readonly record struct SecondaryRay(Ray Ray, Intensity Weight, int Pixel);
