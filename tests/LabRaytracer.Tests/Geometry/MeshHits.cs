namespace LabRaytracer.Tests;

/// <summary>Nearest hits of rays with a mesh at a lane width: by its tree, or by a loop over all triangles.</summary>
internal sealed unsafe class MeshHits<R, F, I> : IDisposable
    where R : unmanaged, ILane<R, F, I>
    where F : unmanaged, ILane<F, F, I>
    where I : unmanaged, IIndexLane<I>
{
    private readonly LaneMemory _memory = new();

    public MeshHits(Ray[] rays, double limit = double.PositiveInfinity)
    {
        Rays = new RayBatch<R, F, I>(_memory, rays.Length) { Count = rays.Length };
        Hits = new HitBatch<R, F, I>(_memory, rays.Length);
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

        Hits.Clear(Rays);
    }

    public RayBatch<R, F, I> Rays { get; }

    public HitBatch<R, F, I> Hits { get; }

    /// <summary>Finds the nearest hits by the tree.</summary>
    public static MeshHit[] ByTree(TriangleMesh mesh, Ray[] rays, double limit = double.PositiveInfinity, int threads = 1, Transform? transform = null)
    {
        using MeshHits<R, F, I> run = new(rays, limit);
        ShapeGroup<R, F, I> group = Group(mesh, threads, run._memory, transform ?? Transform.Identity);
        group.Nearest(0, run.Rays, run.Hits, 0, run.Rays.Packets);
        return run.Found();
    }

    /// <summary>Which rays the tree blocks.</summary>
    public static bool[] Blocked(TriangleMesh mesh, Ray[] rays, double limit) => Blocked(mesh, rays, [.. rays.Select(_ => limit)]);

    /// <summary>Which rays the tree blocks, each before a limit of its own; not above 0 for a ray that is off. A ray may leave a triangle.</summary>
    public static bool[] Blocked(TriangleMesh mesh, Ray[] rays, double[] limits, int[]? sources = null)
    {
        using MeshHits<R, F, I> run = new(rays);
        for (int i = 0; i < rays.Length; i++)
        {
            R.Put(run.Rays.Limit, i, limits[i]);
            ((int*)run.Rays.Source)[i] = sources == null ? -1 : 0;
            ((int*)run.Rays.SourcePart)[i] = sources == null ? -1 : sources[i];
        }

        Group(mesh, 1, run._memory, Transform.Identity).Block(0, run.Rays, 0, run.Rays.Packets);
        return [.. Enumerable.Range(0, rays.Length).Select(i => limits[i] > 0 && R.Take(run.Rays.Limit, i) < 0)];
    }

    /// <summary>Finds the nearest hits by testing every triangle, but the one that a ray may leave.</summary>
    public static MeshHit[] ByLoop(TriangleMesh mesh, Ray[] rays, double limit = double.PositiveInfinity, int[]? sources = null)
    {
        using MeshHits<R, F, I> run = new(rays, limit);
        for (int packet = 0; packet < run.Rays.Packets; packet++)
        {
            WatertightRay<R> ray = new(run.Rays.Load(packet));
            for (int triangle = 0; triangle < mesh.TriangleCount; triangle++)
            {
                (R x0, R y0, R z0) = Corner(mesh, triangle, 0);
                (R x1, R y1, R z1) = Corner(mesh, triangle, 1);
                (R x2, R y2, R z2) = Corner(mesh, triangle, 2);
                R mask = WatertightTriangle.Intersect(ray, x0, y0, z0, x1, y1, z1, x2, y2, z2, out R t, out R a, out R b);
                run.KeepNearer(packet, mask, t, a, b, triangle, sources);
            }
        }

        return run.Found();
    }

    public void Dispose() => _memory.Dispose();

    private static ShapeGroup<R, F, I> Group(TriangleMesh mesh, int threads, LaneMemory memory, Transform transform)
    {
        ShapeGroup<R, F, I> group = mesh.CreateGroup<R, F, I>(transform);
        group.Add(mesh, transform, 0);
        group.Freeze(memory, threads);
        return group;
    }

    private static (R X, R Y, R Z) Corner(TriangleMesh mesh, int triangle, int corner)
    {
        Point3D p = mesh.Data.Position(triangle, corner);
        return (R.Of(p.X), R.Of(p.Y), R.Of(p.Z));
    }

    private void KeepNearer(int packet, R mask, R t, R a, R b, int triangle, int[]? sources)
    {
        for (int lane = 0; lane < R.Width; lane++)
        {
            int ray = (packet * R.Width) + lane;
            if (((R.Bits(mask) >> lane) & 1) != 0 && (sources == null || sources[Math.Min(ray, sources.Length - 1)] != triangle) && R.Get(t, lane) < R.Take(Hits.T, ray))
            {
                R.Put(Hits.T, ray, R.Get(t, lane));
                R.Put(Hits.A, ray, R.Get(a, lane));
                R.Put(Hits.B, ray, R.Get(b, lane));
                ((int*)Hits.Object)[ray] = 0;
                ((int*)Hits.Part)[ray] = triangle;
            }
        }
    }

    private MeshHit[] Found()
    {
        MeshHit[] found = new MeshHit[Rays.Count];
        for (int i = 0; i < found.Length; i++)
        {
            if (((int*)Hits.Object)[i] == 0)
            {
                found[i] = new MeshHit(R.Take(Hits.T, i), ((int*)Hits.Part)[i], R.Take(Hits.A, i), R.Take(Hits.B, i));
            }
        }

        return found;
    }
}

/// <summary>A hit, or the default value (T = 0) for a miss.</summary>
internal readonly record struct MeshHit(double T, int Part, double A, double B);
