namespace LabRaytracer;

/// <summary>A flat parallelogram (Polish: prostokąt, when its edges are perpendicular); by default the square of the sheet's rectangular mapping.</summary>
/// <remarks>
/// <para>Immutable, thread safe. Hit from both sides; the normal is the direction of second edge x first edge.</para>
/// <para>Local frame: the centre is 0, local x runs from -1 to 1 along the first edge and local z along the second, y is 0. So
/// <see cref="RectangularMapping"/> gives v along the first edge and u along the second, both [0, 1], and the picture is not mirrored
/// when seen from the side of the normal (lab sheet IV, section 1.1.1).</para>
/// </remarks>
public sealed class Quad : Shape, IFlatShape
{
    private static readonly RectangularMapping s_mapping = new();

    /// <summary>Creates the square [-1, 1] x [-1, 1] of the plane y = 0 with normal +Y.</summary>
    public Quad()
        : this(new Point3D(-1, 0, -1), 2 * Vector3D.UnitX, 2 * Vector3D.UnitZ)
    {
    }

    /// <summary>Creates a parallelogram.</summary>
    /// <param name="corner">The corner with u = 0, v = 0, object space; finite.</param>
    /// <param name="edgeV">Edge from the corner along which v grows, object units; finite, not 0.</param>
    /// <param name="edgeU">Edge from the corner along which u grows, object units; finite, not 0, not parallel to the other.</param>
    /// <exception cref="ArgumentException">A number is not finite, or the edges span no area.</exception>
    public Quad(Point3D corner, Vector3D edgeV, Vector3D edgeU)
    {
        if (!corner.IsFinite || !edgeV.IsFinite || !edgeU.IsFinite)
        {
            throw new ArgumentException($"A quad needs a finite corner and finite edges; got {corner}, {edgeV} and {edgeU}.");
        }

        Vector3D area = ShapeChecks.Area(
            edgeU, edgeV, $"The edges {edgeV} and {edgeU} of a quad span no area: they must differ from 0 and must not be parallel.");
        Corner = corner;
        EdgeV = edgeV;
        EdgeU = edgeU;
        Frame = new FlatFrame(corner + (edgeV * 0.5) + (edgeU * 0.5), area, edgeV * 0.5, edgeU * 0.5);
    }

    /// <summary>The corner with u = 0, v = 0, object space.</summary>
    public Point3D Corner { get; }

    /// <summary>Edge from the corner along which v (and local x) grows, object units.</summary>
    public Vector3D EdgeV { get; }

    /// <summary>Edge from the corner along which u (and local z) grows, object units.</summary>
    public Vector3D EdgeU { get; }

    /// <summary>Unit normal, object space.</summary>
    public Vector3D Normal => Frame.Normal;

    /// <inheritdoc/>
    public override Bounds Bounds => Bounds.Empty
        .Including(Corner).Including(Corner + EdgeV).Including(Corner + EdgeU).Including(Corner + EdgeV + EdgeU).Grown(4);

    /// <inheritdoc/>
    /// <remarks><see cref="RectangularMapping"/>.</remarks>
    public override IMapping DefaultMapping => s_mapping;

    private FlatFrame Frame { get; }

    FlatFrame IFlatShape.Frame => Frame;

    /// <inheritdoc/>
    public override bool Intersect(in Ray ray, double limit, out Hit hit) => ScalarKernel<FlatKernel<SquareOutline>>.Intersect(this, ray, limit, out hit);

    /// <inheritdoc/>
    public override SurfacePoint SurfaceAt(in Ray ray, in Hit hit) => ScalarKernel<FlatKernel<SquareOutline>>.SurfaceAt(this, ray, hit);

    internal override ShapeGroup<R, F, I> CreateGroup<R, F, I>(Transform transform) => KernelGroups.Create<FlatKernel<SquareOutline>, R, F, I>(transform);
}
