namespace LabRaytracer;

/// <summary>An upright cone (Polish: stożek): the apex above a circular base.</summary>
/// <remarks>
/// <para>Immutable, thread safe. The axis is parallel to +Y; use the transform of the scene object for another. Hit from outside and from inside; the normal points outward.</para>
/// <para>Local points have the apex at (0, 1, 0) and a base of radius 1 at y = -1: x² + z² = ((1 - y) / 2)².</para>
/// <para>Accuracy as for <see cref="Cylinder"/>: hit or miss is decided with twice the digits where it is close, t is within 2.5 units of 2^-53.</para>
/// </remarks>
public sealed class Cone : Shape
{
    private static readonly ConeMapping s_mapping = new();

    /// <summary>Creates a cone.</summary>
    /// <param name="center">The middle of its axis, halfway between apex and base, object space; finite.</param>
    /// <param name="radius">Radius of the base, object units; finite, above 0. Default: 1.</param>
    /// <param name="height">Distance of the apex from the base, object units; finite, above 0. Default: 2.</param>
    /// <param name="caps">Whether it has a base. Default: closed.</param>
    /// <exception cref="ArgumentOutOfRangeException">The centre is not finite, the radius or the height is not a finite number above 0, or the caps are unknown.</exception>
    public Cone(Point3D center = default, double radius = 1, double height = 2, ConeCaps caps = ConeCaps.Closed)
    {
        Center = ShapeChecks.Finite(center, "centre of a cone");
        Radius = ShapeChecks.Positive(radius, "radius of a cone");
        Height = ShapeChecks.Positive(height, "height of a cone");
        Caps = PropertyChecks.Known(caps);
    }

    /// <summary>The middle of the axis, object space.</summary>
    public Point3D Center { get; }

    /// <summary>Radius of the base, object units.</summary>
    public double Radius { get; }

    /// <summary>Distance of the apex from the base, object units.</summary>
    public double Height { get; }

    /// <summary>Whether the cone has a base.</summary>
    public ConeCaps Caps { get; }

    /// <inheritdoc/>
    public override Bounds Bounds
    {
        get
        {
            Vector3D reach = new(Radius, Height / 2, Radius);
            return new Bounds(Center - reach, Center + reach).Grown(4);
        }
    }

    /// <inheritdoc/>
    /// <remarks><see cref="ConeMapping"/>.</remarks>
    public override IMapping DefaultMapping => s_mapping;

    /// <inheritdoc/>
    public override bool Intersect(in Ray ray, double limit, out Hit hit) => ScalarKernel<ConeKernel>.Intersect(this, ray, limit, out hit);

    /// <inheritdoc/>
    public override SurfacePoint SurfaceAt(in Ray ray, in Hit hit) => ScalarKernel<ConeKernel>.SurfaceAt(this, ray, hit);

    internal override ShapeGroup<R, F, I> CreateGroup<R, F, I>(Transform transform) => KernelGroups.Create<ConeKernel, R, F, I>(transform);
}
