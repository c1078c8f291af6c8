namespace LabRaytracer.Validation;

/// <summary>What must never happen: gaps in a closed mesh, a ray that meets the surface it leaves, a quick look that drops a hit, a wrong texel.</summary>
internal sealed class MeetingSweep(StressOptions options)
{
    private const int ShapesPerPart = 132, RaysPerShape = 32;

    private static readonly string[] s_shapes = ["sphere", "cylinder", "plane", "disk", "quad", "box", "triangle"];

    /// <summary>All lines of the table.</summary>
    public IEnumerable<StressRow> Run() =>
        s_shapes.Select(QuickLook)
            .Concat(s_shapes.Select(SelfHit<Double16, Float16, Int16>))
            .Concat(s_shapes.Select(SelfHit<Float16, Float16, Int16>))
            .Append(Watertight<Double16, Float16, Int16>())
            .Append(Watertight<Float16, Float16, Int16>());

    /// <summary>One ray a group of lanes, so that nothing else keeps the group alive: the renderer finds what the formula alone finds.</summary>
    private StressRow QuickLook(string name)
    {
        Worst worst = new($"{name}: hits lost by the quick look", 0, "");
        Parallel.For(0, options.Parts(200), part =>
        {
            Draws draws = Draws.Of(options.Seed, "look" + name, part);
            for (int i = 0; i < ShapesPerPart; i++)
            {
                string kind = StressRays.Kinds[i % StressRays.Kinds.Length];
                Shape shape = StressRays.Create(draws, name, kind, out Point3D center, out double size);
                Ray[] rays = [.. Enumerable.Range(0, RaysPerShape).Select(_ => StressRays.At(draws, kind, center, size))];
                using RayRun<Double1, Float1, Int1> run = new(shape, Transform.Identity, rays);
                for (int ray = 0; ray < rays.Length; ray++)
                {
                    worst.Count(!shape.Intersect(rays[ray], double.PositiveInfinity, out _) || run.IsHit(ray), $"{kind}: {shape.Bounds} {rays[ray]}");
                }
            }
        });
        return worst.ToRow();
    }

    /// <summary>Sizes 1e-6 to 1e6, centres up to 1e6 as far as the precision can tell the size from the centre; every third ray leaves almost along the surface.</summary>
    private StressRow SelfHit<R, F, I>(string name)
        where R : unmanaged, ILane<R, F, I>
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I>
    {
        Worst worst = new($"{name}: surfaces that meet their own rays, {(R.IsSingle ? "float" : "double")}", 0, "");
        Parallel.For(0, options.Parts(200), part =>
        {
            Draws draws = Draws.Of(options.Seed, "self" + name + R.IsSingle, part);
            for (int i = 0; i < ShapesPerPart; i++)
            {
                double size = draws.Scale(-6, 6), reach = Math.Min(1e6, size * draws.Scale(-1, R.IsSingle ? 2 : 9));
                Vector3D offset = draws.Direction() * reach;
                Shape shape = At(draws, name, Point3D.Origin + offset, size);
                Ray[] rays = [.. Enumerable.Range(0, RaysPerShape).Select(_ => Towards(draws, Point3D.Origin + offset, size))];
                using RayRun<R, F, I> run = new(shape, Transform.Identity, rays);
                run.Surface();
                Ray[] leaving = [.. Enumerable.Range(0, rays.Length).Where(run.IsHit).Select(ray => run.Leaving(ray, draws))];
                run.Trace(leaving);
                for (int ray = 0; ray < leaving.Length; ray++)
                {
                    worst.Count(!run.IsHit(ray), $"size {size:g3} at {offset}: {leaving[ray]}");
                }
            }
        });
        return worst.ToRow();
    }

    /// <summary>Rays from inside a closed ball of 1280 triangles to its vertices and to points of its edges.</summary>
    private StressRow Watertight<R, F, I>()
        where R : unmanaged, ILane<R, F, I>
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I>
    {
        Worst worst = new($"closed mesh: rays that escape, {(R.IsSingle ? "float" : "double")}", 0, "");
        Parallel.For(0, options.Parts(50), part =>
        {
            Draws draws = Draws.Of(options.Seed, "watertight", part);
            BumpyBall ball = new(draws, 3);
            Ray[] rays = ball.AimedRays(draws);
            using RayRun<R, F, I> run = new(ball.Mesh, Transform.Identity, rays);
            for (int ray = 0; ray < rays.Length; ray++)
            {
                worst.Count(run.IsHit(ray), $"{rays[ray]}");
            }
        });
        return worst.ToRow();
    }

    private static Shape At(Draws draws, string name, Point3D center, double size)
    {
        Vector3D first = draws.Direction() * (size * 1.5), second = draws.Across(first.Normalized()) * size;
        return name switch
        {
            "sphere" => new Sphere(center, size),
            "cylinder" => new Cylinder(center, size, size * draws.Number(0.5, 1.5)),
            "plane" => new InfinitePlane(center, draws.Direction()),
            "disk" => new Disk(center, draws.Direction(), size),
            "quad" => new Quad(center - (first * 0.5), first, second),
            "box" => new Box(center - new Vector3D(size, size * 0.5, size * 0.75), center + new Vector3D(size, size, size * 0.25)),
            _ => new Triangle(center + first, center + second, center - first),
        };
    }

    private static Ray Towards(Draws draws, Point3D center, double size)
    {
        Point3D from = center + (draws.Direction() * (size * draws.Scale(-1, 2))), to = center + (draws.Direction() * (size * draws.Number(0, 1.2)));
        return new Ray(from, to == from ? draws.Direction() : (to - from).Normalized());
    }
}
