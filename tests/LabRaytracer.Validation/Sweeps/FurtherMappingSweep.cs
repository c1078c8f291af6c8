namespace LabRaytracer.Validation;

/// <summary>Mappings whose coordinates are differences (torus, light probe) against the oracle: errors are absolute, in units of 2^-53 of the picture's side (2^-24 in float lanes).</summary>
/// <remarks>
/// Torus: with the distance r from the ring, the difference rho - R is off by at most 2 rho (hypotenuse, 1 ulp) and 1 of itself, so the angle around the tube by
/// (3 + 2 R / r) / 2 pi and its own ulp: below 2 max(1, R / r). Light probe: the direction around the axis is off by at
/// most 4.25 of itself (two quotients, a root), which counts half; with an ulp of the angle and the rounding of the sum below 4.
/// Faults are NaN, coordinates out of range, and bits that differ between a batch and single calls.
/// </remarks>
internal sealed unsafe class FurtherMappingSweep(StressOptions options)
{
    private const int PointsPerPart = 20_000;

    private delegate (Real U, Real V, double Scale) Exact(Real x, Real y, Real z);

    /// <summary>All lines of the table.</summary>
    public IEnumerable<StressRow> Run() =>
        Both("torus", new TorusMapping(), (x, y, z) => Torus(x, y, z, 1), 2, "max(1, R / r)")
            .Concat(Both("thick torus", new TorusMapping(0.25), (x, y, z) => Torus(x, y, z, 0.25), 2, "max(1, R / r)"))
            .Concat(Both("light probe", new LightProbeMapping(), Probe, 4, ""))
            .Concat(Both("light probe to -Z", new LightProbeMapping { Facing = LightProbeFacing.NegativeZ }, (x, y, z) => Probe(x, y, -z), 4, ""));

    private IEnumerable<StressRow> Both(string name, IWideMapping mapping, Exact exact, double bound, string factor) =>
        Run<Double8>(name, mapping, exact, bound, factor).Concat(Run<Float16>(name, mapping, exact, bound, factor));

    private List<StressRow> Run<R>(string name, IWideMapping mapping, Exact exact, double bound, string factor)
        where R : unmanaged, IReal<R>
    {
        string format = R.IsSingle ? "float" : "double", unit = $"2^-{(R.IsSingle ? 24 : 53)} {factor}".TrimEnd();
        Worst[] worst =
        [
            new($"{name} mapping u, v, {format}", bound, unit),
            new($"{name} mapping: NaN, out of range, {format}", 0, ""),
            new($"{name} mapping: batch = single, {format}", 0, ""),
        ];
        Parallel.For(0, options.Parts(20), part =>
        {
            Worst[] own = [.. worst.Select(line => line.Part())];
            Point3D[] points = MappingPoints.Create(Draws.Of(options.Seed, name + format, part), PointsPerPart, R.IsSingle);
            TextureCoordinate[] found = MappingSweep.Map<R>(mapping, points);
            TextureCoordinate[] single = R.IsSingle ? MappingSweep.Map<Float1>(mapping, points) : [.. points.Select(p => mapping.Map(SurfacePosition.At(p.X, p.Y, p.Z)))];
            for (int i = 0; i < points.Length; i++)
            {
                own[2].Count(MappingSweep.Same(found[i], single[i]), $"{points[i]}: {found[i]} in a batch, {single[i]} alone");
                Note(points[i], found[i], exact, R.IsSingle, mapping is TorusMapping, own);
            }

            for (int line = 0; line < worst.Length; line++)
            {
                worst[line].Add(own[line], line > 0);
            }
        });
        return [.. worst.Select(line => line.ToRow())];
    }

    private static void Note(Point3D p, TextureCoordinate c, Exact exact, bool isSingle, bool isOpen, Worst[] worst)
    {
        bool isRight = c.U >= 0 && c.V >= 0 && (isOpen ? c.U < 1 && c.V < 1 : c.U <= 1 && c.V <= 1);
        worst[1].Count(isRight, $"{p}: {c}");
        (Real u, Real v, double scale) = exact(p.X, p.Y, p.Z);
        double error = isRight ? Math.Max(Units(c.U, u, isSingle), Units(c.V, v, isSingle)) / scale : double.PositiveInfinity;
        worst[0].Note(error, $"{p}: {c}");
    }

    private static double Units(double found, Real exact, bool isSingle) => Math.Abs(Real.Scale(found - exact, isSingle ? 24 : 53).ToDouble());

    private static (Real U, Real V, double Scale) Torus(Real x, Real y, Real z, double ring)
    {
        Real outward = Truth.Hypotenuse(x, z) - ring, distance = Truth.Hypotenuse(outward, y);
        double scale = distance.Sign == 0 ? 1 : Math.Max(1, ring / distance.ToDouble());
        return (Truth.Atan2Turns(x, z), Truth.Atan2Turns(y, outward), double.IsFinite(scale) ? scale : double.MaxValue);
    }

    private static (Real U, Real V, double Scale) Probe(Real x, Real y, Real z)
    {
        Real rho = Truth.Hypotenuse(x, y), turns = Truth.Atan2Turns(rho, z);
        return rho.Sign == 0 ? (0.5 + turns, 0.5, 1) : (0.5 + Real.Short(turns * x / rho), 0.5 + Real.Short(turns * y / rho), 1);
    }
}
