namespace LabRaytracer;

/// <summary>An unbounded plane (Polish: płaszczyzna) through a point, with a normal.</summary>
/// <remarks>
/// Immutable, thread safe. Its local frame has the plane at y = 0: the default plane, through the origin with normal +Y, is the (x, z) plane of lab sheet IV,
/// section 1.1.1, where local and object coordinates are the same.
/// </remarks>
public sealed class InfinitePlane : Shape
{
    private static readonly RectangularMapping s_mapping = new();

    /// <summary>Creates the plane y = 0 with normal +Y.</summary>
    public InfinitePlane()
        : this(Point3D.Origin, Vector3D.UnitY)
    {
    }

    /// <summary>Creates a plane.</summary>
    /// <param name="point">A point of the plane, object space; finite. It becomes the origin of texture space.</param>
    /// <param name="normal">Normal, object space; any finite length above 0.</param>
    /// <exception cref="ArgumentOutOfRangeException">The point is not finite, or the normal has no direction.</exception>
    public InfinitePlane(Point3D point, Vector3D normal)
    {
        if (!point.IsFinite)
        {
            throw new ArgumentOutOfRangeException(nameof(point), point, "A point of a plane needs finite coordinates.");
        }

        if (!normal.IsFinite || normal == Vector3D.Zero)
        {
            throw new ArgumentOutOfRangeException(nameof(normal), normal, "The normal of a plane needs a finite length above 0.");
        }

        Point = point;
        Normal = normal.Normalized();
        (LocalX, LocalZ) = PlaneAxes.Of(Normal);
    }

    /// <summary>A point of the plane, object space: the origin of its local frame.</summary>
    public Point3D Point { get; }

    /// <summary>Unit normal, object space: the y axis of the local frame.</summary>
    public Vector3D Normal { get; }

    /// <summary>The x axis of the local frame, object space, length 1; +X for the plane y = c.</summary>
    public Vector3D LocalX { get; }

    /// <summary>The z axis of the local frame, object space, length 1; +Z for the plane y = c.</summary>
    public Vector3D LocalZ { get; }

    /// <inheritdoc/>
    public override Bounds Bounds => Bounds.Everything;

    /// <inheritdoc/>
    /// <remarks><see cref="RectangularMapping"/>: one tile of the texture is 2 x 2 units.</remarks>
    public override IMapping DefaultMapping => s_mapping;

    /// <inheritdoc/>
    public override bool Intersect(in Ray ray, double limit, out Hit hit) => ScalarKernel<PlaneKernel>.Intersect(this, ray, limit, out hit);

    /// <inheritdoc/>
    public override SurfacePoint SurfaceAt(in Ray ray, in Hit hit) => ScalarKernel<PlaneKernel>.SurfaceAt(this, ray, hit);

    internal override ShapeGroup<R, F, I> CreateGroup<R, F, I>(Transform transform) => KernelGroups.Create<PlaneKernel, R, F, I>(transform);
}
