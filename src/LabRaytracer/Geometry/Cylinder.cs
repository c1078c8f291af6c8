namespace LabRaytracer;

/// <summary>The side of an upright cylinder, open at both ends (Polish: walec, powierzchnia boczna).</summary>
/// <remarks>
/// <para>Immutable, thread safe. The axis is parallel to +Y; use the transform of the scene object for another. Hit from outside and from inside;
/// the normal points outward. Add two <see cref="Disk"/> objects for closed ends.</para>
/// <para>Local points have radius 1 and y in [-1, 1] (lab sheet IV, section 1.1.2).</para>
/// <para>Accuracy as for <see cref="Sphere"/>, also for rays along the axis.</para>
/// </remarks>
public sealed class Cylinder : Shape
{
    private static readonly CylindricalMapping s_mapping = new();

    /// <summary>Creates a cylinder.</summary>
    /// <param name="center">The middle of its axis, object space; finite.</param>
    /// <param name="radius">Radius, object units; finite, above 0. Default: 1.</param>
    /// <param name="height">Height from end to end, object units; finite, above 0. Default: 2, y in [-1, 1] around the centre.</param>
    /// <exception cref="ArgumentOutOfRangeException">The centre is not finite, or the radius or the height is not a finite number above 0.</exception>
    public Cylinder(Point3D center = default, double radius = 1, double height = 2)
    {
        Center = ShapeChecks.Finite(center, "centre of a cylinder");
        Radius = ShapeChecks.Positive(radius, "radius of a cylinder");
        Height = ShapeChecks.Positive(height, "height of a cylinder");
    }

    /// <summary>The middle of the axis, object space.</summary>
    public Point3D Center { get; }

    /// <summary>Radius, object units, above 0.</summary>
    public double Radius { get; }

    /// <summary>Height from end to end, object units, above 0.</summary>
    public double Height { get; }

    /// <inheritdoc/>
    public override Bounds Bounds
    {
        get
        {
            Vector3D reach = new(Radius, Height / 2, Radius);
            return new Bounds(Center - reach, Center + reach).Grown(2);
        }
    }

    /// <inheritdoc/>
    /// <remarks><see cref="CylindricalMapping"/>.</remarks>
    public override IMapping DefaultMapping => s_mapping;

    /// <inheritdoc/>
    public override bool Intersect(in Ray ray, double limit, out Hit hit) => ScalarKernel<CylinderKernel>.Intersect(this, ray, limit, out hit);

    /// <inheritdoc/>
    public override SurfacePoint SurfaceAt(in Ray ray, in Hit hit) => ScalarKernel<CylinderKernel>.SurfaceAt(this, ray, hit);

    internal override ShapeGroup<R, F, I> CreateGroup<R, F, I>(Transform transform) => KernelGroups.Create<CylinderKernel, R, F, I>(transform);
}
