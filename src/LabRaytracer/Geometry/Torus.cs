namespace LabRaytracer;

/// <summary>A ring torus around the y axis (Polish: torus).</summary>
/// <remarks>
/// <para>Immutable, thread safe. Hit from outside and from inside the tube; the normal points out of the tube. Use the transform of the scene object for another axis.</para>
/// <para>Local points are relative to the centre and in units of the ring's radius: (sqrt(x² + z²) - 1)² + y² = (tube / ring)².</para>
/// <para>
/// Accuracy: the sign changes of the quartic are bracketed by its extrema, which a cubic without square term gives; where an extremum or the origin is within a few units of
/// the last place of deciding otherwise, twice the digits decide. The visible hit is computed with twice the digits: t within 1 unit of 2^-53, the local point
/// within 8 such units of the surface.
/// </para>
/// </remarks>
public sealed class Torus : Shape
{
    private static readonly TorusMapping s_mapping = new();

    /// <summary>Creates a torus.</summary>
    /// <param name="center">Its centre, object space; finite.</param>
    /// <param name="ringRadius">Distance of the middle of the tube from the centre, object units; finite, above 0. Default: 1.</param>
    /// <param name="tubeRadius">Radius of the tube, object units; above 0, below the ring's radius. Default: 0.25.</param>
    /// <exception cref="ArgumentOutOfRangeException">The centre is not finite, a radius is not a finite number above 0, or the tube is not thinner than the ring.</exception>
    public Torus(Point3D center = default, double ringRadius = 1, double tubeRadius = 0.25)
    {
        Center = ShapeChecks.Finite(center, "centre of a torus");
        RingRadius = ShapeChecks.Positive(ringRadius, "ring radius of a torus");
        TubeRadius = ShapeChecks.Positive(tubeRadius, "tube radius of a torus");
        if (tubeRadius >= ringRadius)
        {
            throw new ArgumentOutOfRangeException(nameof(tubeRadius), tubeRadius, $"The tube of a torus must be thinner than its ring: below {ringRadius}.");
        }
    }

    /// <summary>The centre, object space.</summary>
    public Point3D Center { get; }

    /// <summary>Distance of the middle of the tube from the centre, object units.</summary>
    public double RingRadius { get; }

    /// <summary>Radius of the tube, object units.</summary>
    public double TubeRadius { get; }

    /// <inheritdoc/>
    public override Bounds Bounds
    {
        get
        {
            double reach = RingRadius + TubeRadius;
            Vector3D half = new(reach, TubeRadius, reach);
            return new Bounds(Center - half, Center + half).Grown(4);
        }
    }

    /// <inheritdoc/>
    /// <remarks><see cref="TorusMapping"/>.</remarks>
    public override IMapping DefaultMapping => s_mapping;

    /// <inheritdoc/>
    public override bool Intersect(in Ray ray, double limit, out Hit hit) => ScalarKernel<TorusKernel>.Intersect(this, ray, limit, out hit);

    /// <inheritdoc/>
    public override SurfacePoint SurfaceAt(in Ray ray, in Hit hit) => ScalarKernel<TorusKernel>.SurfaceAt(this, ray, hit);

    internal override ShapeGroup<R, F, I> CreateGroup<R, F, I>(Transform transform) => KernelGroups.Create<TorusKernel, R, F, I>(transform);
}
