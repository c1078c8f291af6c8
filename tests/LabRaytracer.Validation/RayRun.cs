namespace LabRaytracer.Validation;

/// <summary>Rays against one shape by the renderer's own stages: nearest hits in groups of lanes, then surface points.</summary>
internal sealed unsafe class RayRun<R, F, I> : IDisposable
    where R : unmanaged, ILane<R, F, I>
    where F : unmanaged, ILane<F, F, I>
    where I : unmanaged, IIndexLane<I>
{
    private readonly LaneMemory _memory = new();
    private readonly ShapeGroup<R, F, I> _group;
    private readonly RayBatch<R, F, I> _rays;
    private readonly HitBatch<R, F, I> _hits;
    private readonly int* _order;
    private readonly int* _memberOfObject;
    private int[] _elements = [];

    public RayRun(Shape shape, Transform transform, IReadOnlyList<Ray> rays)
    {
        _rays = new RayBatch<R, F, I>(_memory, rays.Count);
        _hits = new HitBatch<R, F, I>(_memory, rays.Count);
        Surfaces = new SurfaceBatch<R, F, I>(_memory, rays.Count);
        _order = _memory.Column<int>(rays.Count + 16, 1);
        _memberOfObject = _memory.Column<int>(16, 1);
        _group = shape.CreateGroup<R, F, I>(transform);
        _group.Add(shape, transform, 0);
        _group.Freeze(_memory, 1);
        Trace(rays);
    }

    /// <summary>Surface points; those of ray i are at <see cref="Element"/>.</summary>
    public SurfaceBatch<R, F, I> Surfaces { get; }

    /// <summary>Nearest hits of other rays, no more than at first.</summary>
    public void Trace(IReadOnlyList<Ray> rays)
    {
        _rays.Count = rays.Count;
        _rays.PadTail();
        for (int i = 0; i < rays.Count; i++)
        {
            R.Put(_rays.OriginX, i, rays[i].Origin.X);
            R.Put(_rays.OriginY, i, rays[i].Origin.Y);
            R.Put(_rays.OriginZ, i, rays[i].Origin.Z);
            R.Put(_rays.DirectionX, i, rays[i].Direction.X);
            R.Put(_rays.DirectionY, i, rays[i].Direction.Y);
            R.Put(_rays.DirectionZ, i, rays[i].Direction.Z);
            R.Put(_rays.Limit, i, double.PositiveInfinity);
        }

        Nearest();
    }

    /// <summary>Nearest hits of the rays again.</summary>
    public void Nearest()
    {
        _rays.Narrow();
        _hits.Clear(_rays);
        _group.Nearest(0, _rays, _hits, 0, _rays.Packets);
    }

    /// <summary>Surface points of all rays that hit; t becomes as accurate as is promised.</summary>
    /// <param name="precision">Double, or exact in double lanes.</param>
    public void Surface(Precision precision = Precision.Double)
    {
        SurfaceNeeds needs = SurfaceNeeds.LocalPoint | SurfaceNeeds.LocalNormal | SurfaceNeeds.SurfaceCoordinates | SurfaceNeeds.Parameter;
        int[] hit = [.. Enumerable.Range(0, _rays.Count).Where(IsHit)];
        for (int i = 0; i < hit.Length + 16; i++)
        {
            _order[i] = hit.Length == 0 ? 0 : hit[Math.Min(i, hit.Length - 1)];
        }

        _elements = new int[_rays.Count];
        for (int i = 0; i < hit.Length; i++)
        {
            _elements[hit[i]] = i;
        }

        _group.Surface(_rays, _hits, _order, hit.Length, _memberOfObject, Surfaces, precision == Precision.Exact ? needs | SurfaceNeeds.Sharp : needs);
    }

    /// <summary>Number of a ray's surface point.</summary>
    public int Element(int ray) => _elements[ray];

    public bool IsHit(int ray) => ((int*)_hits.Object)[ray] != HitBatch<R, F, I>.Miss;

    public double Distance(int ray) => R.Take(_hits.T, ray);

    public Point3D Local(int ray) => new(
        R.Take(Surfaces.Positions.X, Element(ray)), R.Take(Surfaces.Positions.Y, Element(ray)), R.Take(Surfaces.Positions.Z, Element(ray)));

    /// <summary>The shape's own texture coordinates where a ray hit it.</summary>
    public (double U, double V) SurfaceCoordinates(int ray) => (R.Take(Surfaces.Positions.SurfaceU, Element(ray)), R.Take(Surfaces.Positions.SurfaceV, Element(ray)));

    /// <summary>A ray that leaves the surface where one hit it, from just outside its slack; one in three almost along the surface.</summary>
    public Ray Leaving(int ray, Draws draws)
    {
        int at = Element(ray);
        Vector3D normal = new(R.Take(Surfaces.NormalX, at), R.Take(Surfaces.NormalY, at), R.Take(Surfaces.NormalZ, at));
        Point3D point = new(R.Take(Surfaces.PointX, at), R.Take(Surfaces.PointY, at), R.Take(Surfaces.PointZ, at));
        Vector3D direction = draws.Direction();
        double up = Vector3D.Dot(direction, normal);
        direction = draws.Integer(3) == 0 ? direction - (normal * (up - draws.Scale(R.IsSingle ? -5 : -12, -1))) : up < 0 ? -direction : direction;
        return new Ray(point + (normal * R.Take(Surfaces.Slack, at)), direction.Normalized());
    }

    public void Dispose() => _memory.Dispose();
}
