namespace LabRaytracer;

/// <summary>A triangle (Polish: trójkąt).</summary>
/// <remarks>
/// <para>Immutable, thread safe. Hit from both sides; seen from the side of the normal the vertices run counter-clockwise.</para>
/// <para>The test is watertight: a ray never passes between two triangles that share an edge. Its own texture coordinates are interpolated from the vertices;
/// without any given they are (0, 0), (1, 0), (0, 1): the weights of the second and third vertex. Local points are object-space points.</para>
/// </remarks>
public sealed class Triangle : Shape
{
    private static readonly MeshMapping s_mapping = new();
    private static readonly TextureCoordinate[] s_coordinates = [new(0, 0), new(1, 0), new(0, 1)];

    /// <summary>Creates a triangle.</summary>
    /// <param name="a">First vertex, object space; finite.</param>
    /// <param name="b">Second vertex, object space; finite.</param>
    /// <param name="c">Third vertex, object space; finite.</param>
    /// <exception cref="ArgumentException">A vertex is not finite, or the vertices lie on one line.</exception>
    public Triangle(Point3D a, Point3D b, Point3D c)
    {
        if (!a.IsFinite || !b.IsFinite || !c.IsFinite)
        {
            throw new ArgumentException($"A triangle needs three finite vertices; got {a}, {b} and {c}.");
        }

        A = a;
        B = b;
        C = c;
        Normal = ShapeChecks.Area(
            b - a, c - a, $"The vertices {a}, {b} and {c} of a triangle lie on one line: they must be three different points that span an area.");
        VertexNormals = [Normal, Normal, Normal];
        VertexCoordinates = s_coordinates;
    }

    /// <summary>First vertex, object space.</summary>
    public Point3D A { get; }

    /// <summary>Second vertex, object space.</summary>
    public Point3D B { get; }

    /// <summary>Third vertex, object space.</summary>
    public Point3D C { get; }

    /// <summary>Unit normal of the plane, direction of (B - A) x (C - A), object space.</summary>
    public Vector3D Normal { get; }

    /// <summary>Unit normals at the vertices for smooth shading, object space. Default: the plane's normal, three times.</summary>
    /// <exception cref="ArgumentException">Not three normals, or one without direction (when set).</exception>
    public IReadOnlyList<Vector3D> VertexNormals
    {
        get;
        init
        {
            ArgumentNullException.ThrowIfNull(value);
            if (value.Count != 3 || value.Any(normal => !normal.IsFinite || normal == Vector3D.Zero))
            {
                throw new ArgumentException("A triangle needs three vertex normals of finite length above 0, one for each vertex.", nameof(value));
            }

            field = [.. value.Select(normal => normal.Normalized())];
        }
    }

    /// <summary>Texture coordinates at the vertices, any finite numbers. Default: (0, 0), (1, 0), (0, 1).</summary>
    /// <exception cref="ArgumentException">Not three coordinates, or one that is not finite (when set).</exception>
    public IReadOnlyList<TextureCoordinate> VertexCoordinates
    {
        get;
        init
        {
            ArgumentNullException.ThrowIfNull(value);
            if (value.Count != 3 || value.Any(coordinate => !double.IsFinite(coordinate.U) || !double.IsFinite(coordinate.V)))
            {
                throw new ArgumentException("A triangle needs three finite texture coordinates, one for each vertex.", nameof(value));
            }

            field = [.. value];
        }
    }

    /// <inheritdoc/>
    public override Bounds Bounds => Bounds.Empty.Including(A).Including(B).Including(C).Grown(2);

    /// <inheritdoc/>
    /// <remarks><see cref="MeshMapping"/>.</remarks>
    public override IMapping DefaultMapping => s_mapping;

    /// <inheritdoc/>
    public override bool Intersect(in Ray ray, double limit, out Hit hit) => ScalarKernel<TriangleKernel>.Intersect(this, ray, limit, out hit);

    /// <inheritdoc/>
    public override SurfacePoint SurfaceAt(in Ray ray, in Hit hit) => ScalarKernel<TriangleKernel>.SurfaceAt(this, ray, hit);

    internal override ShapeGroup<R, F, I> CreateGroup<R, F, I>(Transform transform) => KernelGroups.Create<TriangleKernel, R, F, I>(transform);
}
