namespace LabRaytracer;

/// <summary>Parallel light from infinitely far away, such as the sun (Polish: światło kierunkowe).</summary>
/// <remarks>Immutable, thread safe.</remarks>
public sealed class DirectionalLight : Light
{
    /// <summary>Creates directional light.</summary>
    /// <param name="direction">Direction in which the light travels, world space; any finite length above 0.</param>
    /// <param name="intensity">Linear intensity; finite, not negative.</param>
    /// <exception cref="ArgumentOutOfRangeException">The direction has no length, or the intensity is negative or not finite.</exception>
    public DirectionalLight(Vector3D direction, Intensity intensity)
    {
        Direction = LightChecks.Direction(direction);
        Intensity = LightChecks.Intensity(intensity);
    }

    /// <summary>Direction in which the light travels, world space, length 1.</summary>
    public Vector3D Direction { get; }

    /// <summary>Linear intensity, at least 0.</summary>
    public Intensity Intensity { get; }

    /// <inheritdoc/>
    public override bool TrySample(Point3D point, out LightSample sample)
    {
        sample = new LightSample(-Direction, double.PositiveInfinity, Intensity);
        return true;
    }
}
