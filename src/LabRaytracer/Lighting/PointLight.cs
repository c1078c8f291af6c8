namespace LabRaytracer;

/// <summary>A lamp at a point that shines in all directions (Polish: światło punktowe).</summary>
/// <remarks>Immutable, thread safe.</remarks>
public sealed class PointLight : Light
{
    /// <summary>Creates a point light.</summary>
    /// <param name="position">Position, world space; finite.</param>
    /// <param name="intensity">Linear intensity at distance 0 of no fading; finite, not negative.</param>
    /// <exception cref="ArgumentOutOfRangeException">The position is not finite, or the intensity negative or not finite.</exception>
    public PointLight(Point3D position, Intensity intensity)
    {
        Position = LightChecks.Position(position);
        Intensity = LightChecks.Intensity(intensity);
    }

    /// <summary>Position, world space.</summary>
    public Point3D Position { get; }

    /// <summary>Linear intensity, at least 0.</summary>
    public Intensity Intensity { get; }

    /// <summary>How the light fades with distance. Default: not at all.</summary>
    public Attenuation Attenuation { get; init; } = Attenuation.None;

    /// <inheritdoc/>
    public override bool TrySample(Point3D point, out LightSample sample)
    {
        Vector3D toLight = Position - point;
        double distance = Math.Sqrt(toLight.LengthSquared);
        sample = new LightSample(toLight / distance, distance, Intensity * (float)Attenuation.At(distance));
        return distance > 0;
    }
}
