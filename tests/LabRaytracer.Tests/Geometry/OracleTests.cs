using Xunit.Abstractions;

namespace LabRaytracer.Tests.Geometry;

/// <summary>Decisions, ray parameters and local hits against exact arithmetic.</summary>
public sealed class OracleTests(ITestOutputHelper output)
{
    /// <summary>A unit of local space on the sphere's equator, in texels of a picture 8192 texels wide: 8192 / 2 pi.</summary>
    private const double TexelsPerUnit = 1303.8;

    private static readonly double s_eps = Math.ScaleB(1, -53);
    private static readonly OracleRay[] s_rows = [.. OracleRay.Read()];

    [Fact]
    public void Intersect_AnyOracleRay_HitOrMissIsRightUnlessDecidedBelow1e12()
    {
        OracleRay[] wrong = [.. s_rows.Where(row => row.Gap > 1e-12 && row.Shape.Intersect(row.Ray, double.PositiveInfinity, out _) != row.T.HasValue)];
        Assert.Equal(1022, s_rows.Length);
        Assert.Empty(wrong);
    }

    /// <summary>Three roundings: the two compensated products and the division.</summary>
    [Fact]
    public void Intersect_Plane_DistanceWithinThreeRoundings() => Assert.InRange(
        Worst(row => row.ShapeName == "plane", (row, hit) => Math.Abs(hit.T - row.T!.Value) / row.T.Value / s_eps), 0.1, 3);

    /// <summary>Relative to the distance or the shape's size, whichever is larger: a ray that starts on a surface has t near 0.</summary>
    [Theory]
    [InlineData("sphere", "", 8)]
    [InlineData("cylinder", "", 8)]
    [InlineData("box", "", 8)]
    [InlineData("quad", "", 8)]
    [InlineData("disk", "", 8)]
    [InlineData("triangle", "", 100)]
    [InlineData("sphere", "far", 1)]
    [InlineData("cylinder", "far", 1)]
    [InlineData("sphere", "grazing", 1e6)]
    [InlineData("cylinder", "grazing", 1e6)]
    public void Intersect_OracleRays_DistanceWithinBound(string shape, string kind, double bound) => Assert.InRange(
        Worst(row => row.ShapeName == shape && IsOf(row, kind), DistanceError), 0, bound);

    /// <summary>The bound does not grow with the distance: rays start 1e3 to 1e12 radii away. Grazing rays (to 1e-12) have 1 / sqrt(1e-12) of it.</summary>
    [Theory]
    [InlineData("sphere", "", 1e-11)]
    [InlineData("cylinder", "", 1e-11)]
    [InlineData("box", "", 1e-11)]
    [InlineData("quad", "", 1e-11)]
    [InlineData("disk", "", 1e-11)]
    [InlineData("triangle", "near", 1e-11)]
    [InlineData("sphere", "grazing", 2e-7)]
    [InlineData("cylinder", "grazing", 2e-7)]
    public void SurfaceAt_OracleRays_LocalHitWithinBoundInTexels(string shape, string kind, double bound) => Assert.InRange(
        Worst(row => row.ShapeName == shape && IsOf(row, kind), LocalError), 0, bound);

    /// <summary>In units of the hit's distance from the plane's point, in eps: the angle of incidence enters, the ray's length does not.</summary>
    [Theory]
    [InlineData("far", 100)]
    [InlineData("near", 100)]
    public void SurfaceAt_PlaneOracleRays_PointWithinBound(string kind, double bound) => Assert.InRange(
        Worst(row => row.ShapeName == "plane" && IsOf(row, kind), PlaneError), 0, bound);

    private static bool IsOf(OracleRay row, string kind) => kind switch
    {
        "" => row.Kind != "grazing",
        "near" => row.Kind is "generic" or "tiny" or "huge" or "inside" or "nonunit",
        _ => row.Kind.StartsWith(kind, StringComparison.Ordinal),
    };

    private static double DistanceError(OracleRay row, Hit hit)
    {
        Vector3D size = row.Shape.Bounds.Max - row.Shape.Bounds.Min;
        double scale = Math.Max(row.T!.Value, size.Length / row.Ray.Direction.Length);
        return Math.Abs(hit.T - row.T.Value) / scale / s_eps;
    }

    private static double LocalError(OracleRay row, Hit hit)
    {
        SurfacePosition position = row.Shape.SurfaceAt(row.Ray, hit).Position;
        Vector3D found = row.ShapeName == "triangle" ? new(position.Surface.U, position.Surface.V, 0) : position.LocalPoint.ToVector();
        return (found - new Vector3D(row.Local[0], row.Local[1], row.Local[2])).Length * TexelsPerUnit;
    }

    private static double PlaneError(OracleRay row, Hit hit)
    {
        InfinitePlane plane = (InfinitePlane)row.Shape;
        Point3D local = plane.SurfaceAt(row.Ray, hit).Position.LocalPoint;
        Vector3D exact = new(row.Local[0], row.Local[1], row.Local[2]);
        return ((plane.LocalX * local.X) + (plane.LocalZ * local.Z) - exact).Length / exact.Length / s_eps;
    }

    private double Worst(Func<OracleRay, bool> rows, Func<OracleRay, Hit, double> error)
    {
        double worst = 0;
        int hits = 0;
        foreach (OracleRay row in s_rows.Where(row => row.T.HasValue && rows(row)))
        {
            if (row.Shape.Intersect(row.Ray, double.PositiveInfinity, out Hit hit))
            {
                hits++;
                worst = Math.Max(worst, error(row, hit));
            }
        }

        output.WriteLine($"{hits} hits, worst {worst:g3}");
        Assert.True(hits > 8);
        return worst;
    }
}
