namespace LabRaytracer;

/// <summary>A flat disk (Polish: koło, dysk).</summary>
/// <remarks>
/// Immutable, thread safe. Hit from both sides. Local frame: the disk of radius 1 around 0 in the plane y = 0, normal +Y; for the normal +Y the local axes
/// are those of object space.
/// </remarks>
public sealed class Disk : Shape, IFlatShape
{
    private static readonly DiskMapping s_mapping = new();

    /// <summary>Creates the disk of radius 1 around the origin with normal +Y.</summary>
    public Disk()
        : this(Point3D.Origin, Vector3D.UnitY)
    {
    }

    /// <summary>Creates a disk.</summary>
    /// <param name="center">Centre, object space; finite.</param>
    /// <param name="normal">Normal, object space; any finite length above 0.</param>
    /// <param name="radius">Radius, object units; finite, above 0. Default: 1.</param>
    /// <exception cref="ArgumentOutOfRangeException">The centre is not finite, the normal has no direction, or the radius is not a finite number above 0.</exception>
    public Disk(Point3D center, Vector3D normal, double radius = 1)
    {
        Center = ShapeChecks.Finite(center, "centre of a disk");
        Radius = ShapeChecks.Positive(radius, "radius of a disk");
        Normal = ShapeChecks.Direction(normal, "normal of a disk");
        (LocalX, LocalZ) = PlaneAxes.Of(Normal);
        Frame = new FlatFrame(center, Normal, LocalX * radius, LocalZ * radius);
    }

    /// <summary>Centre, object space.</summary>
    public Point3D Center { get; }

    /// <summary>Radius, object units, above 0.</summary>
    public double Radius { get; }

    /// <summary>Unit normal, object space: the y axis of the local frame.</summary>
    public Vector3D Normal { get; }

    /// <summary>The x axis of the local frame, object space, length 1; +X for the normal +Y.</summary>
    public Vector3D LocalX { get; }

    /// <summary>The z axis of the local frame, object space, length 1; +Z for the normal +Y.</summary>
    public Vector3D LocalZ { get; }

    /// <inheritdoc/>
    public override Bounds Bounds
    {
        get
        {
            Vector3D reach = new(Reach(LocalX.X, LocalZ.X), Reach(LocalX.Y, LocalZ.Y), Reach(LocalX.Z, LocalZ.Z));
            return new Bounds(Center - reach, Center + reach).Grown(4);
        }
    }

    /// <inheritdoc/>
    /// <remarks><see cref="DiskMapping"/>.</remarks>
    public override IMapping DefaultMapping => s_mapping;

    private FlatFrame Frame { get; }

    FlatFrame IFlatShape.Frame => Frame;

    /// <inheritdoc/>
    public override bool Intersect(in Ray ray, double limit, out Hit hit) => ScalarKernel<FlatKernel<CircleOutline>>.Intersect(this, ray, limit, out hit);

    /// <inheritdoc/>
    public override SurfacePoint SurfaceAt(in Ray ray, in Hit hit) => ScalarKernel<FlatKernel<CircleOutline>>.SurfaceAt(this, ray, hit);

    internal override ShapeGroup<R, F, I> CreateGroup<R, F, I>(Transform transform) => KernelGroups.Create<FlatKernel<CircleOutline>, R, F, I>(transform);

    private double Reach(double x, double z) => Radius * Math.Sqrt((x * x) + (z * z));
}
