namespace LabRaytracer;

/// <summary>A lamp (Polish: źródło światła).</summary>
/// <remarks>
/// Derive from this class to add a lamp of your own: <see cref="TrySample(Point3D, out LightSample)"/> is enough. Implementations must not change while rendering:
/// the renderer calls them from several threads at once.
/// </remarks>
public abstract class Light
{
    /// <summary>Tells whether objects block this light. Default: yes.</summary>
    public bool CastsShadows { get; init; } = true;

    /// <summary>Samples that are taken of this light at each point, [1, 65536]. Default: 1, for light from one direction.</summary>
    /// <remarks>With more than one, <see cref="TrySample(Point3D, SquarePoint, out LightSample)"/> is asked for each.</remarks>
    public virtual int SampleCount => 1;

    /// <summary>The light that arrives at a point if nothing is in its way.</summary>
    /// <param name="point">The point, world space.</param>
    /// <param name="sample">Direction, distance and intensity.</param>
    /// <returns>False if no light arrives (outside a spot's cone, at the lamp itself).</returns>
    public abstract bool TrySample(Point3D point, out LightSample sample);

    /// <summary>One of several samples of the light that arrives at a point if nothing is in its way. Default: all samples are the same.</summary>
    /// <param name="point">The point, world space.</param>
    /// <param name="place">Where on the lamp the sample lies; the samples of a point fill the unit square evenly, those of neighbouring pixels differ.</param>
    /// <param name="sample">Direction, distance, and the intensity of the whole lamp as if all its light came from there.</param>
    /// <returns>False if no light arrives from there.</returns>
    public virtual bool TrySample(Point3D point, SquarePoint place, out LightSample sample) => TrySample(point, out sample);
}
