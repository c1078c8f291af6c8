using System.Globalization;
using Xunit.Abstractions;

namespace LabRaytracer.Tests.Geometry;

/// <summary>Tori and cones against the roots of their polynomials to 60 digits (Oracle/geometry_curved.py), and by their edges.</summary>
public sealed class CurvedShapeTests(ITestOutputHelper output)
{
    private static readonly double s_eps = Math.ScaleB(1, -53);
    private static readonly Row[] s_rows = [.. Row.Read()];

    [Fact]
    public void Intersect_AnyOracleRay_HitOrMissIsRightUnlessDecidedBelow1e14()
    {
        Row[] wrong = [.. s_rows.Where(row => row.Gap > 1e-14 && row.Shape.Intersect(row.Ray, double.PositiveInfinity, out _) != row.T.HasValue)];
        Assert.Equal(420, s_rows.Length);
        Assert.True(wrong.Length == 0, string.Join("; ", wrong.Select(row => $"{row.Kind} {row.Shape.GetType().Name} gap {row.Gap}")));
    }

    /// <summary>In units of 2^-53 of t, or of the shape's size where t is smaller than that: a ray that starts on a surface has t near 0.</summary>
    [Theory]
    [InlineData("Torus", "generic", 1)]
    [InlineData("Torus", "far", 1)]
    [InlineData("Torus", "inside", 1)]
    [InlineData("Torus", "axis", 1)]
    [InlineData("Torus", "surface", 1)]
    [InlineData("Torus", "grazing", 1)]
    [InlineData("Cone", "generic", 2.5)]
    [InlineData("Cone", "far", 2.5)]
    [InlineData("Cone", "inside", 2.5)]
    [InlineData("Cone", "axis", 2.5)]
    [InlineData("Cone", "surface", 2.5)]
    [InlineData("Cone", "grazing", 2.5)]
    public void Intersect_OracleRays_DistanceWithinBound(string shape, string kind, double bound)
    {
        double worst = 0;
        foreach ((Row row, Hit hit) in Hits(shape, kind))
        {
            double t = row.T!.Value, size = row.Size / row.Ray.Direction.Length;
            worst = Math.Max(worst, Math.Abs(hit.T - t) / Math.Max(Math.Abs(t), size) / s_eps);
        }

        output.WriteLine($"{shape} {kind}: {worst:g3}");
        Assert.InRange(worst, 0, bound);
    }

    /// <summary>In units of 2^-53 of the local form; far rays 1e3 to 1e9 sizes away are no worse than near ones.</summary>
    [Theory]
    [InlineData("Torus", "generic", 8)]
    [InlineData("Torus", "far", 8)]
    [InlineData("Torus", "inside", 8)]
    [InlineData("Torus", "surface", 8)]
    [InlineData("Cone", "generic", 12)]
    [InlineData("Cone", "far", 12)]
    [InlineData("Cone", "inside", 12)]
    [InlineData("Cone", "surface", 12)]
    public void SurfaceAt_OracleRays_LocalPointWithinBound(string shape, string kind, double bound)
    {
        double worst = 0;
        foreach ((Row row, Hit hit) in Hits(shape, kind))
        {
            Point3D p = row.Shape.SurfaceAt(row.Ray, hit).Position.LocalPoint;
            worst = Math.Max(worst, new Vector3D(p.X - row.Local[0], p.Y - row.Local[1], p.Z - row.Local[2]).Length / s_eps);
        }

        output.WriteLine($"{shape} {kind}: {worst:g3}");
        Assert.InRange(worst, 0, bound);
    }

    [Fact]
    public void Torus_RayThroughTheRing_MeetsFourSides()
    {
        var torus = new Torus(tubeRadius: 0.25);
        Ray ray = new(new Point3D(-3, 0, 0), Vector3D.UnitX);
        double[] expected = [1.75, 2.25, 3.75, 4.25];
        double from = 0;
        foreach (double t in expected)
        {
            Ray ahead = new(new Point3D(-3 + from, 0, 0), Vector3D.UnitX);
            Assert.True(torus.Intersect(ahead, double.PositiveInfinity, out Hit hit));
            Assert.Equal(t - from, hit.T, 1e-15);
            from = t + 1e-6;
        }

        Assert.False(torus.Intersect(new Ray(new Point3D(0, 3, 0), -Vector3D.UnitY), double.PositiveInfinity, out _));
        Assert.True(torus.Intersect(ray, 1.76, out _));
        Assert.False(torus.Intersect(ray, 1.74, out _));
    }

    [Fact]
    public void Torus_Top_HasNormalUpAndATangentRayTouches()
    {
        var torus = new Torus(new Point3D(1, 2, 3), 2, 0.5);
        Ray down = new(new Point3D(3, 10, 3), -Vector3D.UnitY);
        Assert.True(torus.Intersect(down, double.PositiveInfinity, out Hit hit));
        Assert.Equal(7.5, hit.T, 1e-14);
        SurfacePoint top = torus.SurfaceAt(down, hit);
        Assert.Equal(Vector3D.UnitY, top.Normal);
        Assert.Equal(new Point3D(1, 0.25, 0), top.Position.LocalPoint);
        Assert.Equal(new TextureCoordinate(0.25, 0.25), torus.DefaultMapping.Map(top.Position));
        Assert.True(torus.Intersect(new Ray(new Point3D(3, 2.5, -10), Vector3D.UnitZ), double.PositiveInfinity, out _));
        Assert.False(torus.Intersect(new Ray(new Point3D(3, 2.5 + 1e-15, -10), Vector3D.UnitZ), double.PositiveInfinity, out _));
    }

    [Theory]
    [InlineData(ConeCaps.Open, 1.5)]
    [InlineData(ConeCaps.Closed, 1)]
    public void Cone_FromBelow_MeetsTheBaseOrTheInside(ConeCaps caps, double t)
    {
        var cone = new Cone(caps: caps);
        Ray up = new(new Point3D(0.75, -2, 0), Vector3D.UnitY);
        Assert.True(cone.Intersect(up, double.PositiveInfinity, out Hit hit));
        Assert.Equal(t, hit.T, 1e-15);
        Assert.Equal(caps == ConeCaps.Closed ? -Vector3D.UnitY : new Vector3D(2, 1, 0).Normalized(), cone.SurfaceAt(up, hit).Normal);
    }

    [Fact]
    public void Cone_ApexAndAxis_AreHitWithoutNaN()
    {
        var cone = new Cone();
        foreach (Ray ray in new[] { new Ray(new Point3D(0, 5, 0), -Vector3D.UnitY), new Ray(new Point3D(-4, 1, 0), Vector3D.UnitX), new Ray(new Point3D(-1, 3, 0), new Vector3D(1, -2, 0)) })
        {
            if (cone.Intersect(ray, double.PositiveInfinity, out Hit hit))
            {
                Assert.True(double.IsFinite(hit.T));
                SurfacePoint point = cone.SurfaceAt(ray, hit);
                Assert.True(point.Normal.IsFinite && point.Point.IsFinite);
                Assert.Equal(1, point.Normal.Length, 1e-14);
            }
        }

        Assert.True(cone.Intersect(new Ray(new Point3D(0, 5, 0), -Vector3D.UnitY), double.PositiveInfinity, out Hit apex));
        Assert.Equal(4, apex.T);
    }

    [Fact]
    public void Options_OutsideTheirRanges_AreRefused()
    {
        Assert.Throws<ArgumentOutOfRangeException>(() => new Torus(tubeRadius: 1));
        Assert.Throws<ArgumentOutOfRangeException>(() => new Torus(ringRadius: 0));
        Assert.Throws<ArgumentOutOfRangeException>(() => new Cone(height: double.NaN));
        Assert.Throws<ArgumentOutOfRangeException>(() => new Cone(caps: (ConeCaps)7));
    }

    private static IEnumerable<(Row Row, Hit Hit)> Hits(string shape, string kind)
    {
        foreach (Row row in s_rows.Where(row => row.Kind == kind && row.Shape.GetType().Name == shape && row is { T: not null, Gap: > 1e-12 }))
        {
            Assert.True(row.Shape.Intersect(row.Ray, double.PositiveInfinity, out Hit hit));
            yield return (row, hit);
        }
    }

    private sealed record Row(string Kind, double Gap, double? T, double[] Local, Ray Ray, Shape Shape, double Size)
    {
        public static IEnumerable<Row> Read()
        {
            string folder = AppContext.BaseDirectory;
            while (!File.Exists(Path.Combine(folder, "LabRaytracer.sln")))
            {
                folder = Path.GetDirectoryName(folder) ?? throw new DirectoryNotFoundException("The tests must run inside the repository.");
            }

            return File.ReadLines(Path.Combine(folder, "tests", "LabRaytracer.Tests", "Geometry", "Data", "curved.csv")).Select(Parse);
        }

        private static Row Parse(string line)
        {
            string[] words = line.Split(',');
            double[] n = [.. words[4..].Select(word => double.Parse(word, CultureInfo.InvariantCulture))];
            Point3D center = new(n[9], n[10], n[11]);
            Shape shape = words[1] == "torus" ? new Torus(center, n[12], n[13]) : new Cone(center, n[12], n[13], n[14] == 0 ? ConeCaps.Open : ConeCaps.Closed);
            return new Row(
                words[0],
                double.Parse(words[2], CultureInfo.InvariantCulture),
                words[3] == "miss" ? null : double.Parse(words[3], CultureInfo.InvariantCulture),
                n[..3],
                new Ray(new Point3D(n[3], n[4], n[5]), new Vector3D(n[6], n[7], n[8])),
                shape,
                n[12] + n[13]);
        }
    }
}
