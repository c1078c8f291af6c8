namespace LabRaytracer;

/// <summary>A lamp (Polish: źródło światła).</summary>
/// <remarks>
/// Derive from this class to add a lamp of your own: <see cref="TrySample"/> is enough. Implementations must not change while rendering:
/// the renderer calls them from several threads at once.
/// </remarks>
public abstract class Light
{
    /// <summary>Tells whether objects block this light. Default: yes.</summary>
    public bool CastsShadows { get; init; } = true;

    /// <summary>The light that arrives at a point if nothing is in its way.</summary>
    /// <param name="point">The point, world space.</param>
    /// <param name="sample">Direction, distance and intensity.</param>
    /// <returns>False if no light arrives (outside a spot's cone, at the lamp itself).</returns>
    public abstract bool TrySample(Point3D point, out LightSample sample);
}
