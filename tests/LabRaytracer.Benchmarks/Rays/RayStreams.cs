namespace LabRaytracer.Benchmarks;

/// <summary>Rays of the bench scene s4 against its mesh alone: from the camera, from what they hit to the lamp, from there in random directions, and from what those hit to the lamp.</summary>
internal sealed class RayStreams<R, F, I> : IDisposable
    where R : unmanaged, ILane<R, F, I>
    where F : unmanaged, ILane<F, F, I>
    where I : unmanaged, IIndexLane<I>
{
    private const int Width = 1920, Height = 1080, Part = 4, Block = 16, Step = 2;
    private readonly LaneMemory _memory = new();

    public RayStreams(TriangleMesh mesh)
    {
        ShapeGroup<R, F, I> group = mesh.CreateGroup<R, F, I>(Transform.Identity);
        group.Add(mesh, Transform.Identity, 0);
        group.Freeze(_memory, 2);
        RayStream<R, F, I> primary = new("primary", mesh, group, _memory, Camera(), isShadow: false);
        primary.Trace(2);
        RayStream<R, F, I> shadow = new("shadow", mesh, group, _memory, ToLamp(mesh, primary), isShadow: true);
        shadow.LeaveFrom(primary);
        RayStream<R, F, I> diffuse = new("diffuse", mesh, group, _memory, Diffuse(mesh, primary), isShadow: false);
        diffuse.Trace(2);
        RayStream<R, F, I> scattered = new("scattered shadow", mesh, group, _memory, ToLamp(mesh, diffuse), isShadow: true);
        scattered.LeaveFrom(diffuse);
        All = [primary, shadow, diffuse, scattered];
    }

    public IReadOnlyList<RayStream<R, F, I>> All { get; }

    public void Dispose() => _memory.Dispose();

    /// <summary>How far outside rays start, for the lanes' precision.</summary>
    private static double Slack(in SurfacePoint surface) => R.IsSingle ? surface.Slack * (1 << 29) : surface.Slack;

    /// <summary>Every second block of 16 x 16 pixels in each direction, each as four of 8 x 8, and these as four of 4 x 4, as the renderer orders them.</summary>
    private static List<(Ray Ray, double Limit)> Camera()
    {
        PerspectiveCamera camera = new(new Point3D(0, 1.8, 3.2), new Point3D(0, -0.1, 0), 40);
        List<(Ray, double)> rays = [];
        for (int y = 0; y < Height; y += Block * Step)
        {
            for (int x = 0; x < Width; x += Block * Step)
            {
                for (int i = 0; i < Block * Block; i++)
                {
                    int part = i / (Part * Part), left = x + (Gathered(part) * Part), top = y + (Gathered(part >> 1) * Part);
                    rays.Add((camera.RayAt(left + (i % Part) + 0.5, top + (i / Part % Part) + 0.5, Width, Height), double.PositiveInfinity));
                }
            }
        }

        return rays;
    }

    /// <summary>Bits 0 and 2 of a number as a number.</summary>
    private static int Gathered(int number) => (number & 1) | ((number >> 1) & 2);

    /// <summary>A ray for each ray that hits; off where it does not, or where the surface faces away.</summary>
    private static List<(Ray Ray, double Limit)> ToLamp(TriangleMesh mesh, RayStream<R, F, I> from)
    {
        Point3D lamp = new(4, 6, 5);
        List<(Ray, double)> rays = [];
        for (int i = 0; i < from.Rays.Count; i++)
        {
            (Ray, double) ray = (new Ray(Point3D.Origin, Vector3D.UnitZ), -1);
            if (from.HitOf(i) is { } hit)
            {
                SurfacePoint surface = mesh.SurfaceAt(from.Rays[i], hit);
                Vector3D toLamp = lamp - surface.Point;
                ray = Vector3D.Dot(surface.Normal, toLamp) > 0 ? (new Ray(surface.Point + (surface.Normal * Slack(surface)), toLamp.Normalized()), toLamp.Length) : ray;
            }

            rays.Add(ray);
        }

        return rays;
    }

    /// <summary>One ray from each hit, its direction cosine-distributed about the normal.</summary>
    private static List<(Ray Ray, double Limit)> Diffuse(TriangleMesh mesh, RayStream<R, F, I> primary)
    {
        Random random = new(1);
        List<(Ray, double)> rays = [];
        for (int i = 0; i < primary.Rays.Count; i++)
        {
            if (primary.HitOf(i) is not { } hit)
            {
                continue;
            }

            SurfacePoint surface = mesh.SurfaceAt(primary.Rays[i], hit);
            Vector3D normal = surface.Normal, aside = Vector3D.Cross(Math.Abs(normal.X) > 0.5 ? Vector3D.UnitY : Vector3D.UnitX, normal).Normalized();
            double square = random.NextDouble();
            (double sin, double cos) = Math.SinCos(2 * Math.PI * random.NextDouble());
            Vector3D direction = (((aside * cos) + (Vector3D.Cross(normal, aside) * sin)) * Math.Sqrt(square)) + (normal * Math.Sqrt(1 - square));
            rays.Add((new Ray(surface.Point + (normal * Slack(surface)), direction.Normalized()), double.PositiveInfinity));
        }

        return rays;
    }
}
