namespace LabRaytracer.Validation;

/// <summary>Texture coordinates of built-in mappings against the oracle, in double lanes and in float lanes.</summary>
/// <remarks>
/// Errors in ulp of the exact coordinate; faults are NaN, u outside [0, 1), v outside its range, a coordinate on the other side of the seam, and bits that differ
/// between a batch and single calls.
/// </remarks>
internal sealed unsafe class MappingSweep(StressOptions options)
{
    private const int PointsPerPart = 20_000;

    private delegate (Real U, Real V) Exact(Real x, Real y, Real z);

    /// <summary>All lines of the table.</summary>
    public IEnumerable<StressRow> Run()
    {
        Exact sphere = Truth.Sphere;
        Exact cylinder = (x, y, z) => (Truth.Atan2Turns(x, z), (y + 1) * 0.5);
        Exact disk = (x, _, z) => (Truth.Atan2Turns(x, z), Truth.Hypotenuse(x, z));
        Exact rectangle = (x, _, z) => ((z + 1) * 0.5, (x + 1) * 0.5);
        IEnumerable<StressRow> Both(string name, IWideMapping mapping, Exact exact, int parts, double boundU, double boundV) =>
            Run<Double8>(name, mapping, exact, parts, boundU, boundV).Concat(Run<Float16>(name, mapping, exact, parts, boundU, boundV));
        return Both("spherical", new SphericalMapping(), sphere, 2600, 1, 1)
            .Concat(Both("cylindrical", new CylindricalMapping(), cylinder, 50, 1, 0.5))
            .Concat(Both("disk", new DiskMapping(), disk, 50, 1, 1))
            .Concat(Both("rectangular", new RectangularMapping(), rectangle, 50, 0.5, 0.5));
    }

    private List<StressRow> Run<R>(string name, IWideMapping mapping, Exact exact, int parts, double boundU, double boundV)
        where R : unmanaged, IReal<R>
    {
        string format = R.IsSingle ? "float" : "double";
        Worst u = new($"{name} mapping u, {format}", boundU, "ulp"), v = new($"{name} mapping v, {format}", boundV, "ulp");
        Worst faults = new($"{name} mapping: NaN, out of range, seam flips, {format}", 0, "");
        Worst subnormal = new($"{name} mapping u, v where something is below {(R.IsSingle ? "1e-30" : "1e-300")}, {format}", 2, "ulp");
        Worst bits = new($"{name} mapping: batch = single, {format}", 0, "");
        Parallel.For(0, options.Parts(parts), part =>
        {
            Point3D[] points = MappingPoints.Create(Draws.Of(options.Seed, name + format, part), PointsPerPart, R.IsSingle);
            TextureCoordinate[] found = Map<R>(mapping, points), single = R.IsSingle ? Map<Float1>(mapping, points) : [.. points.Select(p => mapping.Map(new SurfacePosition(p, default, default)))];
            for (int i = 0; i < points.Length; i++)
            {
                Point3D p = points[i];
                TextureCoordinate c = found[i];
                bits.Count(Same(c, single[i]), $"{p}: {c} in a batch, {single[i]} alone");
                (Real exactU, Real exactV) = exact(p.X, p.Y, p.Z);
                bool isAngle = mapping is not RectangularMapping, isBounded = mapping is SphericalMapping;
                bool isRight = double.IsFinite(c.U) && double.IsFinite(c.V) && (!isAngle || (c.U is >= 0 and < 1)) && (!isBounded || (c.V is >= 0 and <= 1));
                faults.Count(isRight && !(isAngle && Real.Abs(c.U - exactU) > 0.5), $"{p}: {c}");
                double errorU = isAngle && Truth.Nearest(exactU, R.IsSingle) == 1 ? c.U == Below<R>() ? 0 : 99 : Truth.Ulps(c.U, exactU, R.IsSingle);
                double errorV = Truth.Ulps(c.V, exactV, R.IsSingle);
                bool isOrdinary = IsOrdinary<R>(p.X) && IsOrdinary<R>(p.Y) && IsOrdinary<R>(p.Z);
                (isOrdinary && IsOrdinary<R>(c.U) ? u : subnormal).Note(errorU, $"{p}: u {c.U:R}");
                (isOrdinary && IsOrdinary<R>(c.V) ? v : subnormal).Note(errorV, $"{p}: v {c.V:R}");
            }
        });
        return [u.ToRow(), v.ToRow(), subnormal.ToRow(), faults.ToRow(), bits.ToRow()];
    }

    /// <summary>False where a product with a rounding error would underflow.</summary>
    private static bool IsOrdinary<R>(double a)
        where R : unmanaged, IReal<R> => a == 0 || Math.Abs(a) >= (R.IsSingle ? 1e-30 : 1e-300);

    private static TextureCoordinate[] Map<R>(IWideMapping mapping, Point3D[] points)
        where R : unmanaged, IReal<R>
    {
        using Column<R> x = new(points.Length), y = new(points.Length), z = new(points.Length), u = new(points.Length), v = new(points.Length);
        for (int i = 0; i < points.Length; i++)
        {
            (x[i], y[i], z[i]) = (points[i].X, points[i].Y, points[i].Z);
        }

        PositionBatch<R> positions = new() { X = x.Lanes, Y = y.Lanes, Z = z.Lanes };
        mapping.Map(positions, new CoordinateBatch<R> { U = u.Lanes, V = v.Lanes }, (points.Length + R.Width - 1) / R.Width);
        return [.. Enumerable.Range(0, points.Length).Select(i => new TextureCoordinate(u[i], v[i]))];
    }

    private static bool Same(TextureCoordinate a, TextureCoordinate b) =>
        BitConverter.DoubleToInt64Bits(a.U) == BitConverter.DoubleToInt64Bits(b.U) && BitConverter.DoubleToInt64Bits(a.V) == BitConverter.DoubleToInt64Bits(b.V);

    private static double Below<R>()
        where R : unmanaged, IReal<R> => R.IsSingle ? MathF.BitDecrement(1) : Math.BitDecrement(1);
}
