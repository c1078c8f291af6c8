namespace LabRaytracer;

/// <summary>Light from everywhere, the same at every point (Polish: światło otoczenia): multiplies the material's ambient coefficient.</summary>
/// <remarks>Immutable, thread safe.</remarks>
public sealed class AmbientLight : Light
{
    /// <summary>Creates ambient light.</summary>
    /// <param name="intensity">Linear intensity; finite, not negative.</param>
    /// <exception cref="ArgumentOutOfRangeException">A component is negative, NaN or infinite.</exception>
    public AmbientLight(Intensity intensity) => Intensity = LightChecks.Intensity(intensity);

    /// <summary>Linear intensity, at least 0.</summary>
    public Intensity Intensity { get; }

    /// <summary>Ambient light has no direction: never a sample.</summary>
    public override bool TrySample(Point3D point, out LightSample sample)
    {
        sample = default;
        return false;
    }
}
