namespace LabRaytracer;

/// <summary>A surface of triangles that share vertices (Polish: siatka trójkątów).</summary>
/// <remarks>
/// <para>Immutable, thread safe. Rays cannot slip between triangles that share an edge or a vertex. Seen from outside, vertices go round counter-clockwise;
/// where normals for shading say otherwise, the geometric normal follows them.</para>
/// <para>Numbers are kept as floats where all of a kind are exactly floats, else as doubles. The tree that finds triangles is built once, when it is first needed.</para>
/// </remarks>
public sealed class TriangleMesh : Shape
{
    private static readonly MeshMapping s_mapping = new();
    private const int Chunk = 1 << 16;
    private readonly int[]? _kept;
    private readonly Lock _building = new();
    private volatile MeshTree? _tree;

    /// <summary>Creates a mesh.</summary>
    /// <param name="positions">Vertex positions, object space: 3 numbers each, finite, at most 1e18 in magnitude (OBJ: v).</param>
    /// <param name="corners">The three vertices of each triangle, numbered from 0.</param>
    /// <param name="options">Normals, texture coordinates, and what happens to triangles without area; null for the defaults.</param>
    /// <exception cref="ArgumentException">A number is out of range, a length does not fit, or a triangle has no area (see <see cref="MeshOptions.DegenerateTriangles"/>).</exception>
    public TriangleMesh(ReadOnlySpan<double> positions, ReadOnlySpan<int> corners, MeshOptions? options = null)
    {
        options ??= new MeshOptions();
        MeshChecks.Validate(positions, corners, options);
        Data = new MeshData(positions, corners, options);
        _kept = MeshChecks.KeptTriangles(Data, options.DegenerateTriangles);
        Bounds = FindBounds();
    }

    /// <inheritdoc cref="TriangleMesh(ReadOnlySpan{double}, ReadOnlySpan{int}, MeshOptions)"/>
    public TriangleMesh(ReadOnlySpan<float> positions, ReadOnlySpan<int> corners, MeshOptions? options = null)
        : this(Widened(positions), corners, options)
    {
    }

    /// <inheritdoc cref="TriangleMesh(ReadOnlySpan{double}, ReadOnlySpan{int}, MeshOptions)"/>
    public TriangleMesh(IReadOnlyList<Point3D> positions, ReadOnlySpan<int> corners, MeshOptions? options = null)
        : this(Coordinates(positions), corners, options)
    {
    }

    /// <summary>Number of vertex positions.</summary>
    public int VertexCount => Data.VertexCount;

    /// <summary>Number of triangles, those without area included.</summary>
    public int TriangleCount => Data.TriangleCount;

    /// <summary>Number of triangles without area, which no ray hits.</summary>
    public int DegenerateCount => _kept == null ? 0 : TriangleCount - _kept.Length;

    /// <inheritdoc/>
    public override Bounds Bounds { get; }

    /// <inheritdoc/>
    /// <remarks><see cref="MeshMapping"/>: the mesh's own texture coordinates.</remarks>
    public override IMapping DefaultMapping => s_mapping;

    /// <summary>The numbers.</summary>
    internal MeshData Data { get; }

    /// <summary>Bytes that the mesh and, if it is built, its tree take.</summary>
    internal long Bytes => Data.Bytes + (_tree?.Bytes ?? 0);

    /// <inheritdoc/>
    /// <remarks>Builds the tree on the first call.</remarks>
    public override unsafe bool Intersect(in Ray ray, double limit, out Hit hit)
    {
        Double1 t = new(limit), a = default, b = default;
        Int1 owner = new(HitBatch<Double1, Float1, Int1>.Miss), part = default;
        MeshNearestSink<Double1, Float1, Int1> sink = new() { Object = 0, T = &t, A = &a, B = &b, Objects = &owner, Parts = &part };
        MeshTree tree = Tree(1);
        RayLanes<Double1> lanes = Lanes(ray);
        if (tree.Prepare(lanes, t, out BvhRay<Double1, Float1, Int1> boxRay))
        {
            MeshSingle.Nearest(Data, tree, lanes, boxRay, sink);
        }

        GC.KeepAlive(this);
        hit = new Hit(t.Value, part.Value, a.Value, b.Value);
        return owner.Value == 0;
    }

    /// <inheritdoc/>
    public override SurfacePoint SurfaceAt(in Ray ray, in Hit hit)
    {
        MeshSurface.Compute<Double1, Float1, Int1>(
            Data, Lanes(ray), new Int1(hit.Part), new Double1(hit.A), new Double1(hit.B), out SurfaceLanes<Double1> s);
        GC.KeepAlive(this);
        Point3D point = new(s.PointX.Value, s.PointY.Value, s.PointZ.Value);
        Vector3D normal = new(s.NormalX.Value, s.NormalY.Value, s.NormalZ.Value);
        TextureCoordinate surface = new(s.SurfaceU.Value, s.SurfaceV.Value);
        return new SurfacePoint(
            point, normal, new Vector3D(s.ShadingX.Value, s.ShadingY.Value, s.ShadingZ.Value), new SurfacePosition(point, normal, surface), s.Slack.Value);
    }

    /// <summary>The tree of boxes, built by the first who asks.</summary>
    internal MeshTree Tree(int threads)
    {
        if (_tree == null)
        {
            lock (_building)
            {
                _tree ??= BuildTree(threads);
            }
        }

        return _tree;
    }

    /// <summary>A new tree of boxes.</summary>
    internal MeshTree BuildTree(int threads) => new(Data, _kept, Bounds, threads);

    internal override ShapeGroup<R, F, I> CreateGroup<R, F, I>(Transform transform) => new MeshGroup<R, F, I>(!transform.IsIdentity);

    private static RayLanes<Double1> Lanes(in Ray ray) => new(
        new Double1(ray.Origin.X), new Double1(ray.Origin.Y), new Double1(ray.Origin.Z),
        new Double1(ray.Direction.X), new Double1(ray.Direction.Y), new Double1(ray.Direction.Z));

    private static double[] Widened(ReadOnlySpan<float> numbers)
    {
        double[] widened = new double[numbers.Length];
        for (int i = 0; i < numbers.Length; i++)
        {
            widened[i] = numbers[i];
        }

        return widened;
    }

    private static double[] Coordinates(IReadOnlyList<Point3D> points)
    {
        ArgumentNullException.ThrowIfNull(points);
        double[] numbers = new double[3 * points.Count];
        for (int i = 0; i < points.Count; i++)
        {
            (numbers[3 * i], numbers[(3 * i) + 1], numbers[(3 * i) + 2]) = points[i];
        }

        return numbers;
    }

    private Bounds FindBounds()
    {
        int count = _kept?.Length ?? TriangleCount;
        Bounds all = Bounds.Empty;
        Lock joining = new();
        ChunkLoop.Run(count, Chunk, Environment.ProcessorCount, (first, end) =>
        {
            Bounds part = Bounds.Empty;
            for (int i = first; i < end; i++)
            {
                part = Data.BoundsOf(_kept == null ? i : _kept[i], part);
            }

            lock (joining)
            {
                all = Bounds.Union(all, part);
            }
        });
        return all;
    }
}
