namespace LabRaytracer.Tests.Geometry;

/// <summary>Rays through the group of a shape, as the renderer sends them: nearest hits, then surface points.</summary>
internal sealed unsafe class ShapeRun<R, F, I> : IDisposable
    where R : unmanaged, ILane<R, F, I>
    where F : unmanaged, ILane<F, F, I>
    where I : unmanaged, IIndexLane<I>
{
    private readonly LaneMemory _memory = new();
    private readonly ShapeGroup<R, F, I> _group;
    private readonly int _members;
    private readonly int* _order;
    private readonly int* _memberOfObject;

    public ShapeRun(IReadOnlyList<Shape> shapes, Transform transform, int capacity)
    {
        Rays = new RayBatch<R, F, I>(_memory, capacity);
        Hits = new HitBatch<R, F, I>(_memory, capacity);
        Surfaces = new SurfaceBatch<R, F, I>(_memory, capacity);
        _order = _memory.Column<int>(capacity + 16, 1);
        _memberOfObject = _memory.Column<int>(shapes.Count + 16, 1);
        _group = shapes[0].CreateGroup<R, F, I>(transform);
        _members = shapes.Count;
        for (int number = 0; number < shapes.Count; number++)
        {
            _memberOfObject[number] = _group.Add(shapes[number], transform, number);
        }

        _group.Freeze(_memory, 1);
    }

    public RayBatch<R, F, I> Rays { get; }

    public HitBatch<R, F, I> Hits { get; }

    public SurfaceBatch<R, F, I> Surfaces { get; }

    public void SetRays(ReadOnlySpan<Ray> rays, double limit = double.PositiveInfinity)
    {
        Rays.Count = rays.Length;
        Rays.PadTail();
        for (int i = 0; i < rays.Length; i++)
        {
            R.Put(Rays.OriginX, i, rays[i].Origin.X);
            R.Put(Rays.OriginY, i, rays[i].Origin.Y);
            R.Put(Rays.OriginZ, i, rays[i].Origin.Z);
            R.Put(Rays.DirectionX, i, rays[i].Direction.X);
            R.Put(Rays.DirectionY, i, rays[i].Direction.Y);
            R.Put(Rays.DirectionZ, i, rays[i].Direction.Z);
            R.Put(Rays.Limit, i, limit);
        }

        Rays.Narrow();
    }

    public void Nearest()
    {
        Hits.Clear(Rays);
        for (int member = 0; member < _members; member++)
        {
            _group.Nearest(member, Rays, Hits, 0, Rays.Packets);
        }
    }

    public void Block()
    {
        for (int member = 0; member < _members; member++)
        {
            _group.Block(member, Rays, 0, Rays.Packets);
        }
    }

    /// <summary>Surface points of all rays that hit, and t as accurate as is promised unless nobody asks for it; returns the numbers of these rays.</summary>
    public int[] Surface(bool asksForT = true)
    {
        int[] hit = [.. Enumerable.Range(0, Rays.Count).Where(IsHit)];
        for (int i = 0; i < hit.Length + 16; i++)
        {
            _order[i] = hit.Length == 0 ? 0 : hit[Math.Min(i, hit.Length - 1)];
        }

        SurfaceNeeds all = SurfaceNeeds.LocalPoint | SurfaceNeeds.LocalNormal | SurfaceNeeds.SurfaceCoordinates;
        _group.Surface(Rays, Hits, _order, hit.Length, _memberOfObject, Surfaces, asksForT ? all | SurfaceNeeds.Parameter : all);
        return hit;
    }

    public bool IsHit(int ray) => ((int*)Hits.Object)[ray] != HitBatch<R, F, I>.Miss;

    public int ObjectOf(int ray) => ((int*)Hits.Object)[ray];

    public double Distance(int ray) => R.Take(Hits.T, ray);

    public bool IsBlocked(int ray) => R.Take(Rays.Limit, ray) < 0;

    /// <summary>All numbers of a surface point: point, normal, shading normal, local point, local normal, own coordinates, slack.</summary>
    public double[] SurfaceNumbers(int element)
    {
        R*[] columns =
        [
            Surfaces.PointX, Surfaces.PointY, Surfaces.PointZ, Surfaces.NormalX, Surfaces.NormalY, Surfaces.NormalZ,
            Surfaces.ShadingX, Surfaces.ShadingY, Surfaces.ShadingZ, Surfaces.Positions.X, Surfaces.Positions.Y, Surfaces.Positions.Z,
            Surfaces.Positions.NormalX, Surfaces.Positions.NormalY, Surfaces.Positions.NormalZ,
            Surfaces.Positions.SurfaceU, Surfaces.Positions.SurfaceV, Surfaces.Slack,
        ];
        double[] numbers = new double[columns.Length];
        for (int k = 0; k < numbers.Length; k++)
        {
            numbers[k] = R.Take(columns[k], element);
        }

        return numbers;
    }

    public static double[] Numbers(in SurfacePoint s) =>
    [
        s.Point.X, s.Point.Y, s.Point.Z, s.Normal.X, s.Normal.Y, s.Normal.Z, s.ShadingNormal.X, s.ShadingNormal.Y, s.ShadingNormal.Z,
        s.Position.LocalPoint.X, s.Position.LocalPoint.Y, s.Position.LocalPoint.Z,
        s.Position.LocalNormal.X, s.Position.LocalNormal.Y, s.Position.LocalNormal.Z, s.Position.Surface.U, s.Position.Surface.V, s.Slack,
    ];

    public void Dispose() => _memory.Dispose();
}
