namespace LabRaytracer;

/// <summary>Bounds of rays that are known without looking at each. Directions count times a factor, another one for each ray, none below <paramref name="LeastFactor"/>.</summary>
/// <param name="LeastOrigin">No origin has a smaller coordinate.</param>
/// <param name="LargestOrigin">No origin has a larger coordinate.</param>
/// <param name="LeastDirection">No direction, times its ray's factor, has a smaller coordinate.</param>
/// <param name="LargestDirection">No direction, times its ray's factor, has a larger coordinate.</param>
/// <param name="LeastFactor">No factor is smaller; at least 0.</param>
/// <param name="Limit">No ray parameter over its ray's factor is of interest beyond.</param>
internal readonly record struct RayBounds(
    Point3D LeastOrigin, Point3D LargestOrigin, Vector3D LeastDirection, Vector3D LargestDirection, double LeastFactor, double Limit)
{
    /// <summary>The point through which all rays pass but for rounding, where they have one.</summary>
    public Point3D Apex { get; init; }

    /// <summary>1 where rays start at the <see cref="Apex"/>, -1 where they end there, 0 where there is none.</summary>
    public int Sense { get; init; }
}
