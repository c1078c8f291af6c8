using System.Globalization;

namespace LabRaytracer.Benchmarks;

/// <summary>Rays of one kind in groups of lanes, and what they hit.</summary>
internal sealed unsafe class RayStream<R, F, I>
    where R : unmanaged, ILane<R, F, I>
    where F : unmanaged, ILane<F, F, I>
    where I : unmanaged, IIndexLane<I>
{
    private const int Packets = 64, Checked = 4000;
    private readonly TriangleMesh _mesh;
    private readonly ShapeGroup<R, F, I> _group;
    private readonly HitBatch<R, F, I>? _hits;
    private readonly R* _limits;

    public RayStream(string name, TriangleMesh mesh, ShapeGroup<R, F, I> group, LaneMemory memory, List<(Ray Ray, double Limit)> rays, bool isShadow)
    {
        Name = name;
        _mesh = mesh;
        _group = group;
        Rays = new RayBatch<R, F, I>(memory, rays.Count) { Count = rays.Count };
        _hits = isShadow ? null : new HitBatch<R, F, I>(memory, rays.Count);
        for (int i = 0; i < rays.Count; i++)
        {
            (Ray ray, double limit) = rays[i];
            R.Put(Rays.OriginX, i, ray.Origin.X);
            R.Put(Rays.OriginY, i, ray.Origin.Y);
            R.Put(Rays.OriginZ, i, ray.Origin.Z);
            R.Put(Rays.DirectionX, i, ray.Direction.X);
            R.Put(Rays.DirectionY, i, ray.Direction.Y);
            R.Put(Rays.DirectionZ, i, ray.Direction.Z);
            R.Put(Rays.Limit, i, limit);
        }

        Rays.PadTail();
        Rays.Narrow();
        RayCount = rays.Count(ray => ray.Limit > 0);
        _limits = memory.Column<R>(rays.Count, R.Width);
        new Span<R>(Rays.Limit, Rays.Packets).CopyTo(new Span<R>(_limits, Rays.Packets));
    }

    public string Name { get; }

    public RayBatch<R, F, I> Rays { get; }

    /// <summary>Rays that are not off.</summary>
    public int RayCount { get; }

    /// <summary>How many hit or are blocked.</summary>
    public int HitCount => Enumerable.Range(0, Rays.Count).Count(IsHit);

    /// <summary>Tells each shadow ray which triangle it leaves, as the renderer does.</summary>
    public void LeaveFrom(RayStream<R, F, I> surfaces)
    {
        for (int i = 0; i < Rays.Count; i++)
        {
            ((int*)Rays.Source)[i] = surfaces.IsHit(i) ? 0 : -1;
            ((int*)Rays.SourcePart)[i] = ((int*)surfaces._hits!.Part)[i];
        }
    }

    public void Trace(int threads)
    {
        int parts = (Rays.Packets + Packets - 1) / Packets;
        Parallel.For(0, parts, new ParallelOptions { MaxDegreeOfParallelism = threads }, part => Trace(part * Packets, Math.Min(Rays.Packets, (part + 1) * Packets)));
    }

    public Hit? HitOf(int ray) => IsHit(ray) ? new Hit(R.Take(_hits!.T, ray), ((int*)_hits.Part)[ray], R.Take(_hits.A, ray), R.Take(_hits.B, ray)) : null;

    /// <summary>How the first rays agree with one ray at a time in doubles.</summary>
    public string Agreement()
    {
        int same = 0, count = 0;
        double worst = 0;
        for (int i = 0; i < Rays.Count && count < Checked; i++)
        {
            double limit = R.Take(_limits, i);
            if (!(limit > 0))
            {
                continue;
            }

            count++;
            bool isHit = _mesh.Intersect(Rays[i], limit, out Hit hit);
            same += isHit == IsHit(i) ? 1 : 0;
            worst = isHit && _hits != null && HitOf(i) is { } own ? Math.Max(worst, Math.Abs((own.T - hit.T) / hit.T)) : worst;
        }

        return string.Create(CultureInfo.InvariantCulture, $"{same} of {count} agree with one lane of double, t within {worst:0.0e+0}");
    }

    private bool IsHit(int ray) => _hits == null
        ? R.Take(_limits, ray) > 0 && R.Take(Rays.Limit, ray) < 0
        : ((int*)_hits.Object)[ray] != HitBatch<R, F, I>.Miss;

    private void Trace(int first, int end)
    {
        int packets = end - first;
        new Span<R>(_limits + first, packets).CopyTo(new Span<R>(Rays.Limit + first, packets));
        if (_hits == null)
        {
            _group.Block(0, Rays, first, end);
            return;
        }

        new Span<R>(_limits + first, packets).CopyTo(new Span<R>(_hits.T + first, packets));
        new Span<int>((int*)(_hits.Object + first), packets * R.Width).Fill(HitBatch<R, F, I>.Miss);
        _group.Nearest(0, Rays, _hits, first, end);
    }
}
