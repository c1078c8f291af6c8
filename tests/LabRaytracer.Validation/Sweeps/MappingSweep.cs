namespace LabRaytracer.Validation;

/// <summary>Texture coordinates of built-in mappings against the oracle, in double lanes and in float lanes.</summary>
/// <remarks>
/// Errors in ulp of the exact coordinate; faults are NaN, u outside [0, 1), v outside its range, a coordinate on the other side of the seam, and bits that differ
/// between a batch and single calls.
/// </remarks>
internal sealed unsafe class MappingSweep(StressOptions options)
{
    private const int PointsPerPart = 20_000;

    private const int Checked = 1009;

    private delegate (Real U, Real V) Exact(Real x, Real y, Real z);

    private delegate bool Quick(double x, double y, double z, out Pair u, out Pair v);

    /// <summary>All lines of the table.</summary>
    public IEnumerable<StressRow> Run() =>
        Both("spherical", new SphericalMapping(), Truth.Sphere, QuickTruth.TrySphere, 2600, 1, 1)
            .Concat(Both("cylindrical", new CylindricalMapping(), (x, y, z) => (Truth.Atan2Turns(x, z), (y + 1) * 0.5), QuickTruth.TryCylinder, 100, 1, 0.5))
            .Concat(Both("disk", new DiskMapping(), (x, _, z) => (Truth.Atan2Turns(x, z), Truth.Hypotenuse(x, z)), QuickTruth.TryDisk, 100, 1, 1))
            .Concat(Both("rectangular", new RectangularMapping(), (x, _, z) => ((z + 1) * 0.5, (x + 1) * 0.5), QuickTruth.TryRectangle, 100, 0.5, 0.5))
            .Concat(Both("box", new BoxMapping(), (x, y, z) => (Half(Right(x, y, z)), Half(Up(x, y, z))), QuickTruth.TryBox, 100, 0.5, 0.5))
            .Concat(Both("hemispherical", new HemisphericalMapping(), Hemisphere, QuickTruth.TryHemisphere, 100, 1, 2))
            .Concat(Both("equal-area", new EqualAreaMapping(), EqualArea, null, 10, 1, 8))
            .Concat(Both("cone", new ConeMapping(), Cone, null, 10, 1, 0.5));

    private IEnumerable<StressRow> Both(string name, IWideMapping mapping, Exact exact, Quick? quick, int parts, double boundU, double boundV)
    {
        Worst oracle = new($"{name} mapping: quick form of the oracle against 256 bits", 1, "units of 2^-90");
        List<StressRow> rows = [.. Run<Double8>(name, mapping, exact, quick, parts, boundU, boundV, oracle), .. Run<Float16>(name, mapping, exact, quick, parts, boundU, boundV, oracle)];
        return quick is null ? rows : rows.Append(oracle.ToRow());
    }

    private List<StressRow> Run<R>(string name, IWideMapping mapping, Exact exact, Quick? quick, int parts, double boundU, double boundV, Worst oracle)
        where R : unmanaged, IReal<R>
    {
        string format = R.IsSingle ? "float" : "double";
        Worst[] worst =
        [
            new($"{name} mapping u, {format}", boundU, "ulp"),
            new($"{name} mapping v, {format}", boundV, "ulp"),
            new($"{name} mapping u, v where something is below {(R.IsSingle ? "1e-30" : "1e-300")}, {format}", boundV > 1 ? 3 * boundV : 1, "ulp"),
            new($"{name} mapping: NaN, out of range, seam flips, {format}", 0, ""),
            new($"{name} mapping: batch = single, {format}", 0, ""),
        ];
        Parallel.For(0, options.Parts(parts), part =>
        {
            Worst[] own = [.. worst.Select(line => line.Part())];
            Point3D[] points = MappingPoints.Create(Draws.Of(options.Seed, name + format, part), PointsPerPart, R.IsSingle);
            TextureCoordinate[] found = Map<R>(mapping, points), single = R.IsSingle ? Map<Float1>(mapping, points) : [.. points.Select(p => mapping.Map(new SurfacePosition(p, Normal(p), default)))];
            for (int i = 0; i < points.Length; i++)
            {
                own[4].Count(Same(found[i], single[i]), $"{points[i]}: {found[i]} in a batch, {single[i]} alone");
                Note<R>(mapping, points[i], found[i], exact, quick, own);
                if (i % Checked == 0 && quick is not null)
                {
                    Compare(points[i], exact, quick, oracle);
                }
            }

            for (int line = 0; line < worst.Length; line++)
            {
                worst[line].Add(own[line], line > 2);
            }
        });
        return [.. worst.Select(line => line.ToRow())];
    }

    /// <summary>Judges one point: by the quick oracle where it is there and certain, else by the slow one.</summary>
    private static void Note<R>(IWideMapping mapping, Point3D p, TextureCoordinate c, Exact exact, Quick? quick, Worst[] worst)
        where R : unmanaged, IReal<R>
    {
        bool isAngle = mapping is not (RectangularMapping or BoxMapping) && !(mapping is ConeMapping && Normal(p).Y < 0);
        bool isBounded = mapping is SphericalMapping or HemisphericalMapping or EqualAreaMapping, isOrdinary = IsOrdinary<R>(p.X) && IsOrdinary<R>(p.Y) && IsOrdinary<R>(p.Z);
        Worst u = isOrdinary && IsOrdinary<R>(c.U) ? worst[0] : worst[2], v = isOrdinary && IsOrdinary<R>(c.V) ? worst[1] : worst[2];
        double errorU = 0, errorV = 0, awayU = 0;
        (Pair quickU, Pair quickV) = (default, default);
        bool isSure = quick is not null && quick(p.X, p.Y, p.Z, out quickU, out quickV) && (!isAngle || quickU.High < 0.9999);
        if (isSure)
        {
            (errorU, errorV, awayU) = (quickU.Ulps(c.U, R.IsSingle), quickV.Ulps(c.V, R.IsSingle), Math.Abs(c.U - quickU.High));
            isSure = errorU <= Sure(u) && errorV <= Sure(v);
        }

        if (!isSure)
        {
            (Real exactU, Real exactV) = exact(p.X, p.Y, p.Z);
            errorU = isAngle && Truth.Nearest(exactU, R.IsSingle) == 1 ? c.U == Below<R>() ? 0 : 99 : Truth.Ulps(c.U, exactU, R.IsSingle);
            (errorV, awayU) = (Truth.Ulps(c.V, exactV, R.IsSingle), double.IsFinite(c.U) ? Math.Abs((c.U - exactU).ToDouble()) : 0);
        }

        bool isRight = double.IsFinite(c.U) && double.IsFinite(c.V) && (!isAngle || (c.U is >= 0 and < 1)) && (!isBounded || (c.V is >= 0 and <= 1));
        worst[3].Count(isRight && !(isAngle && awayU > 0.5), $"{p}: {c}");
        u.Note(errorU, $"{p}: u {c.U:R}");
        v.Note(errorV, $"{p}: v {c.V:R}");
    }

    /// <summary>Errors above are looked at with all digits.</summary>
    private static double Sure(Worst line) => line.Bound > 0.5 ? 0.95 * line.Bound : line.Bound;

    private static void Compare(Point3D p, Exact exact, Quick quick, Worst oracle)
    {
        if (quick(p.X, p.Y, p.Z, out Pair u, out Pair v))
        {
            (Real exactU, Real exactV) = exact(p.X, p.Y, p.Z);
            oracle.Note(Math.Max(Units(u, exactU), Units(v, exactV)), $"{p}: {u}, {v}");
        }
    }

    private static double Units(Pair found, Real exact) =>
        exact.Sign == 0 ? found.High == 0 ? 0 : double.PositiveInfinity : Math.Abs(Real.Scale((found.ToReal() - exact) / exact, 90).ToDouble());

    /// <summary>False where a product with a rounding error would underflow.</summary>
    private static bool IsOrdinary<R>(double a)
        where R : unmanaged, IReal<R> => a == 0 || Math.Abs(a) >= (R.IsSingle ? 1e-30 : 1e-300);

    /// <summary>Texture coordinates of points by the path for many.</summary>
    public static TextureCoordinate[] Map<R>(IWideMapping mapping, Point3D[] points)
        where R : unmanaged, IReal<R>
    {
        using Column<R> x = new(points.Length), y = new(points.Length), z = new(points.Length), u = new(points.Length), v = new(points.Length);
        using Column<R> normalX = new(points.Length), normalY = new(points.Length), normalZ = new(points.Length);
        for (int i = 0; i < points.Length; i++)
        {
            (x[i], y[i], z[i]) = (points[i].X, points[i].Y, points[i].Z);
            Vector3D normal = Normal(points[i]);
            (normalX[i], normalY[i], normalZ[i]) = (normal.X, normal.Y, normal.Z);
        }

        PositionBatch<R> positions = new()
        {
            X = x.Lanes, Y = y.Lanes, Z = z.Lanes, NormalX = normalX.Lanes, NormalY = normalY.Lanes, NormalZ = normalZ.Lanes,
        };
        mapping.Map(positions, new CoordinateBatch<R> { U = u.Lanes, V = v.Lanes }, (points.Length + R.Width - 1) / R.Width);
        return [.. Enumerable.Range(0, points.Length).Select(i => new TextureCoordinate(u[i], v[i]))];
    }

    private static (Real U, Real V) Hemisphere(Real x, Real y, Real z) => (Truth.Atan2Turns(x, z), y.Sign > 0 ? 4 * Truth.Atan2Turns(y, Truth.Hypotenuse(x, z)) : 0);

    private static (Real U, Real V) EqualArea(Real x, Real y, Real z)
    {
        // Below the equator (1 + y / r) / 2 would lose all digits: it is rho² / (2 r (r - y)).
        Real flat = (x * x) + (z * z), length = Real.Sqrt(Real.Short(flat + (y * y), 400));
        return (Truth.Atan2Turns(x, z), length.Sign == 0 ? 0.5 : y.Sign < 0 ? Real.Short(flat / (2 * length * (length - y))) : Half(Real.Short(y / length)));
    }

    /// <summary>The base is where the direction that stands for the normal points down.</summary>
    private static (Real U, Real V) Cone(Real x, Real y, Real z) => x.Sign < 0 ? (Half(x), Half(z)) : (Truth.Atan2Turns(x, z), Half(y));

    private static Real Half(Real a) => (a + 1) * 0.5;

    /// <summary>What runs to the right on a point's face of the box, whose normal is (z, x, y): x before y before z among equals.</summary>
    private static Real Right(Real x, Real y, Real z) => IsOnX(x, y, z) ? z.Sign < 0 ? z : -z : Real.Abs(x) >= Real.Abs(y) || y.Sign >= 0 ? x : -x;

    /// <summary>What runs upwards there.</summary>
    private static Real Up(Real x, Real y, Real z) => IsOnX(x, y, z) || Real.Abs(x) < Real.Abs(y) ? y : x.Sign < 0 ? z : -z;

    private static bool IsOnX(Real x, Real y, Real z) => Real.Abs(z) >= Real.Abs(x) && Real.Abs(z) >= Real.Abs(y);

    /// <summary>A direction that says which face of the box a point belongs to; any will do.</summary>
    private static Vector3D Normal(Point3D p) => new(p.Z, p.X, p.Y);

    /// <summary>Tells whether coordinates have the same bits.</summary>
    public static bool Same(TextureCoordinate a, TextureCoordinate b) =>
        BitConverter.DoubleToInt64Bits(a.U) == BitConverter.DoubleToInt64Bits(b.U) && BitConverter.DoubleToInt64Bits(a.V) == BitConverter.DoubleToInt64Bits(b.V);

    private static double Below<R>()
        where R : unmanaged, IReal<R> => R.IsSingle ? MathF.BitDecrement(1) : Math.BitDecrement(1);
}
