namespace LabRaytracer.Validation;

/// <summary>Hits and misses, ray parameters and local hits in the renderer's default lanes against exact arithmetic.</summary>
/// <remarks>
/// eps is 2^-53. Curved shapes are measured in texels of a picture 8192 texels wide, at any distance and grazing. The frames of flat shapes are rounded where they
/// lie: the unit there is eps times (distance of the centre from the origin + size) / size.
/// </remarks>
internal sealed class RaySweep(StressOptions options)
{
    private const int ShapesPerPart = 110, RaysPerShape = 32;

    /// <summary>A unit of local space on the equator of a sphere, in texels of a picture 8192 texels wide.</summary>
    private const double TexelsPerUnit = 8192 / (2 * Math.PI);

    private static readonly double s_eps = Math.ScaleB(1, -53);

    /// <summary>All lines of the table.</summary>
    public IEnumerable<StressRow> Run() =>
        Run("sphere", 2e-16, 2.5)
            .Concat(Run("cylinder", 2e-16, 2.5))
            .Concat(Run("plane", 2e-16, 2))
            .Concat(Run("disk", 4e-15, double.NaN))
            .Concat(Run("quad", 4e-15, double.NaN))
            .Concat(Run("box", 4e-15, double.NaN));

    private IEnumerable<StressRow> Run(string name, double gap, double boundT)
    {
        Worst decisions = new($"{name}: wrong hit or miss", 0, ""), t = new($"{name}: t", boundT, "eps");
        Worst texel = name is "sphere" or "cylinder"
            ? new($"{name}: local hit", 1e-11, "texel")
            : new($"{name}: local hit, times the cosine of incidence", 16, "eps (c + r)"), off = new($"{name}: local hit off the surface", 3, "eps r");
        Worst bits = new($"{name}: batch = single", 0, ""), sharp = new($"{name}: t, exact mode", 0.5, "ulp");
        Parallel.For(0, options.Parts(500), part =>
        {
            Draws draws = Draws.Of(options.Seed, name, part);
            for (int i = 0; i < ShapesPerPart; i++)
            {
                string kind = StressRays.Kinds[i % StressRays.Kinds.Length];
                Shape shape = StressRays.Create(draws, name, kind, out Point3D center, out double size);
                Ray[] rays = [.. Enumerable.Range(0, RaysPerShape).Select(_ => StressRays.At(draws, kind, center, size))];
                using RayRun<Double16, Float16, Int16> run = new(shape, Transform.Identity, rays);
                run.Surface();
                ExactHit[] exacts = [.. rays.Select(ray => ExactHit.Of(shape, ray))];
                for (int ray = 0; ray < rays.Length; ray++)
                {
                    ExactHit exact = exacts[ray];
                    if (exact.Gap > gap)
                    {
                        decisions.Count(run.IsHit(ray) == exact.IsHit, $"{kind}: {shape.Bounds} {rays[ray]}, gap {exact.Gap:e2}, hit {exact.IsHit}");
                    }

                    bool isHit = shape.Intersect(rays[ray], double.PositiveInfinity, out Hit single);
                    bits.Count(isHit == run.IsHit(ray) && (!isHit || single.T == run.Distance(ray)), $"{kind}: {rays[ray]}");
                    if (exact.IsHit && run.IsHit(ray) && exact.Gap > gap)
                    {
                        // Where the hit is at the origin but for 1e-16 of the size, two words end at 2^-100 of the size.
                        double least = Math.ScaleB(size / rays[ray].Direction.Length, -100) / exact.T.ToDouble();
                        t.Note(Math.Max(0, Math.Abs(((run.Distance(ray) - exact.T) / exact.T).ToDouble()) - least) / s_eps, $"{kind}: {rays[ray]}, gap {exact.Gap:e2}");
                        Point3D local = run.Local(ray);
                        double unit = name is "sphere" or "cylinder" ? 1 / TexelsPerUnit : s_eps * (1 + (center.ToVector().Length / size));
                        texel.Note(Distance(local, exact) * Cosine(shape, rays[ray], exact) / unit, $"{kind}: {rays[ray]}, gap {exact.Gap:e2}");
                        off.Note(Off(shape, local) / s_eps, $"{kind}: {rays[ray]}");
                    }
                }

                NoteExactMode(run, rays, exacts, sharp);
            }
        });
        List<StressRow> rows = [decisions.ToRow(), bits.ToRow()];
        if (!double.IsNaN(boundT))
        {
            rows.AddRange([t.ToRow(), sharp.ToRow()]);
        }

        if (name != "plane")
        {
            rows.Add(texel.ToRow());
        }

        if (name is "sphere" or "cylinder")
        {
            rows.Add(off.ToRow());
        }

        return rows;
    }

    /// <summary>Every t again, correctly rounded wherever there is a hit at all.</summary>
    private static void NoteExactMode(RayRun<Double16, Float16, Int16> run, Ray[] rays, ExactHit[] exacts, Worst worst)
    {
        run.Surface(Precision.Exact);
        for (int ray = 0; ray < rays.Length; ray++)
        {
            if (exacts[ray].IsHit && run.IsHit(ray))
            {
                worst.Note(Truth.Ulps(run.Distance(ray), exacts[ray].T, false), $"{rays[ray]}, gap {exacts[ray].Gap:e2}");
            }
        }
    }

    private static double Distance(Point3D found, in ExactHit exact)
    {
        double x = (found.X - exact.X).ToDouble(), y = (found.Y - exact.Y).ToDouble(), z = (found.Z - exact.Z).ToDouble();
        return Math.Sqrt((x * x) + (y * y) + (z * z));
    }

    /// <summary>What a flat face seen at a slant multiplies every error by; 1 for curved shapes.</summary>
    private static double Cosine(Shape shape, in Ray ray, in ExactHit exact)
    {
        Vector3D normal = shape switch
        {
            Disk disk => disk.Normal,
            Quad quad => quad.Normal,
            Box => Math.Abs(exact.X.ToDouble()) > 1 - 1e-15 ? Vector3D.UnitX : Math.Abs(exact.Y.ToDouble()) > 1 - 1e-15 ? Vector3D.UnitY : Vector3D.UnitZ,
            _ => Vector3D.Zero,
        };
        return normal == Vector3D.Zero ? 1 : Math.Abs(Vector3D.Dot(normal, ray.Direction)) / ray.Direction.Length;
    }

    /// <summary>Distance of a local point from the unit sphere, or from the unit cylinder.</summary>
    private static double Off(Shape shape, Point3D p)
    {
        Real square = ((Real)p.X * p.X) + ((Real)p.Z * p.Z) + (shape is Sphere ? (Real)p.Y * p.Y : 0);
        return Math.Abs((Real.Sqrt(square) - 1).ToDouble());
    }
}
