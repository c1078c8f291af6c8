using System.Numerics;

namespace LabRaytracer.Validation;

/// <summary>From a ray to a texel of a picture of 8192 x 4096 by the renderer's own stages: nearest hit, surface, spherical mapping, texel.</summary>
internal sealed unsafe class EndToEndSweep(StressOptions options)
{
    private const int ShapesPerPart = 110, RaysPerShape = 48, Width = 8192, Height = 4096;
    private const double Margin = 1e-9;

    /// <summary>All lines of the table.</summary>
    public IEnumerable<StressRow> Run()
    {
        Worst worst = new("ray to texel of a sphere: missed, NaN or wrong texel", 0, "");
        Parallel.For(0, options.Parts(400), part =>
        {
            Draws draws = Draws.Of(options.Seed, "end to end", part);
            for (int i = 0; i < ShapesPerPart; i++)
            {
                string kind = StressRays.Kinds[i % StressRays.Kinds.Length];
                Shape shape = StressRays.Create(draws, "sphere", kind, out Point3D center, out double size);
                Ray[] rays = [.. Enumerable.Range(0, RaysPerShape).Select(_ => StressRays.At(draws, kind, center, size))];
                using RayRun<Double16, Float16, Int16> run = new(shape, Transform.Identity, rays);
                run.Surface();
                (int X, int Y)[] texels = Texels(run, rays.Length);
                for (int ray = 0; ray < rays.Length; ray++)
                {
                    ExactHit exact = ExactHit.Of(shape, rays[ray]);
                    if (exact.IsHit && exact.Gap > 2e-16 && Texel(exact) is { } expected)
                    {
                        worst.Count(run.IsHit(ray) && texels[run.Element(ray)] == expected, $"{kind}: {shape.Bounds} {rays[ray]}, gap {exact.Gap:e2}");
                    }
                }
            }
        });
        return [worst.ToRow()];
    }

    /// <summary>The texel of an exact hit; null within the margin of another.</summary>
    private static (int X, int Y)? Texel(in ExactHit exact)
    {
        (Real u, Real v) = Truth.Sphere(Real.Short(exact.X), Real.Short(exact.Y), Real.Short(exact.Z));
        Real x = u * Width, y = v * Height;
        BigInteger column = Real.Floor(x), row = Real.Floor(y);
        double restX = (x - Real.FromFixed(column, 0)).ToDouble(), restY = (y - Real.FromFixed(row, 0)).ToDouble();
        bool isSure = Math.Min(restX, restY) > Margin && Math.Max(restX, restY) < 1 - Margin;
        return isSure ? ((int)column, (int)row) : null;
    }

    private static (int X, int Y)[] Texels(RayRun<Double16, Float16, Int16> run, int count)
    {
        using Column<Double16> u = new(count), v = new(count);
        TexelAxis across = new(Width, TextureWrap.Repeat, TexelConvention.Center), up = new(Height, TextureWrap.Clamp, TexelConvention.Center);
        int packets = (count + Double16.Width - 1) / Double16.Width;
        ((IWideMapping)new SphericalMapping()).Map(run.Surfaces.Positions, new CoordinateBatch<Double16> { U = u.Lanes, V = v.Lanes }, packets);
        (int X, int Y)[] texels = new (int, int)[count];
        for (int i = 0; i < count; i++)
        {
            across.Nearest<Double16, Float16, Int16>(u.Lanes[i / Double16.Width], out Int16 x);
            up.Nearest<Double16, Float16, Int16>(v.Lanes[i / Double16.Width], out Int16 y);
            texels[i] = (Int16.Get(x, i % Double16.Width), Int16.Get(y, i % Double16.Width));
        }

        return texels;
    }
}
