namespace LabRaytracer.Tests.Geometry;

/// <summary>Defaults, edges, degenerate rays and degenerate arguments.</summary>
public sealed class ShapeEdgeTests
{
    private static readonly double s_infinity = double.PositiveInfinity;

    public static TheoryData<string> Kinds => [.. ShapeCases.Kinds];

    [Fact]
    public void Quad_Default_IsTheSheetsSquareWithUAlongZ()
    {
        Quad quad = new();
        Ray ray = new(new Point3D(0.5, 3, -0.5), -Vector3D.UnitY);
        Assert.True(quad.Intersect(ray, s_infinity, out Hit hit));
        SurfacePoint s = quad.SurfaceAt(ray, hit);
        Assert.Equal(3, hit.T);
        Assert.Equal(new Vector3D(0, 1, 0), s.Normal);
        Assert.Equal(new Point3D(0.5, 0, -0.5), s.Position.LocalPoint);
        Assert.Equal(new TextureCoordinate(0.25, 0.75), quad.DefaultMapping.Map(s.Position));
    }

    [Fact]
    public void Quad_Parallelogram_CoordinatesFollowTheEdges()
    {
        // v along (2, 0, 0), u along (1, 0, 3): the corner is (0, 0); half along v and a third along u is (1.5, 0, 1) + (0, 1, 0).
        Quad quad = new(new Point3D(0, 1, 0), new Vector3D(2, 0, 0), new Vector3D(1, 0, 3));
        Ray ray = new(new Point3D(1 + (1 / 3.0), -4, 1), Vector3D.UnitY);
        Assert.True(quad.Intersect(ray, s_infinity, out Hit hit));
        SurfacePoint s = quad.SurfaceAt(ray, hit);
        TextureCoordinate uv = quad.DefaultMapping.Map(s.Position);
        Assert.Equal(1 / 3.0, uv.U, 1e-15);
        Assert.Equal(0.5, uv.V, 1e-15);
        Assert.Equal(new Vector3D(0, 1, 0), s.Normal);
        Assert.Equal(5, hit.T, 1e-15);
    }

    [Fact]
    public void Cylinder_HeightRange_IsHitInsideAndMissedAbove()
    {
        Cylinder cylinder = new(new Point3D(0, 10, 0), 2, 6);
        Assert.True(cylinder.Intersect(new Ray(new Point3D(5, 13, 0), -Vector3D.UnitX), s_infinity, out Hit hit));
        Assert.Equal(3, hit.T);
        Assert.False(cylinder.Intersect(new Ray(new Point3D(5, 13.0001, 0), -Vector3D.UnitX), s_infinity, out _));
        Ray inside = new(new Point3D(0, 8.5, 0), Vector3D.UnitZ);
        Assert.True(cylinder.Intersect(inside, s_infinity, out hit));
        SurfacePoint s = cylinder.SurfaceAt(inside, hit);
        Assert.Equal(2, hit.T);
        Assert.Equal(Vector3D.UnitZ, s.Normal);
        Assert.Equal(new Point3D(0, -0.5, 1), s.Position.LocalPoint);
    }

    [Fact]
    public void Cylinder_RayFromAboveThroughTheOpenEnd_HitsTheInnerWall()
    {
        Ray ray = new(new Point3D(0, 2, 0), new Vector3D(1, -1.5, 0));
        Assert.True(new Cylinder().Intersect(ray, s_infinity, out Hit hit));
        Assert.Equal(1, hit.T, 1e-15);
        Assert.False(new Cylinder().Intersect(new Ray(new Point3D(0, 2, 0), -Vector3D.UnitY), s_infinity, out _));
    }

    [Theory]
    [InlineData(3, 0.25, 0.5, -1, 0, 0, 1, 0, 0, 2)]
    [InlineData(0.25, 4, 0.5, 0, -1, 0, 0, 1, 0, 3)]
    [InlineData(0.25, 0.5, -3, 0, 0, 1, 0, 0, -1, 2)]
    [InlineData(0, 0, 0, 0, 0, 1, 0, 0, 1, 1)]
    [InlineData(0, 0, 0, 0, -2, 0, 0, -1, 0, 0.5)]
    public void Box_Face_NormalPointsOutward(double ox, double oy, double oz, double dx, double dy, double dz, double nx, double ny, double nz, double t)
    {
        Ray ray = new(new Point3D(ox, oy, oz), new Vector3D(dx, dy, dz));
        Box box = new();
        Assert.True(box.Intersect(ray, s_infinity, out Hit hit));
        SurfacePoint s = box.SurfaceAt(ray, hit);
        Assert.Equal(t, hit.T);
        Assert.Equal(new Vector3D(nx, ny, nz), s.Normal);
        Assert.Equal(s.Normal, s.Position.LocalNormal);
        Assert.Equal(1, Vector3D.Dot(s.Position.LocalPoint.ToVector(), s.Normal));
    }

    [Fact]
    public void Disk_Rim_IsIncluded()
    {
        Disk disk = new(new Point3D(1, 2, 3), Vector3D.UnitY, 2);
        Assert.True(disk.Intersect(new Ray(new Point3D(3, 5, 3), -Vector3D.UnitY), s_infinity, out Hit hit));
        Assert.Equal(3, hit.T);
        Assert.False(disk.Intersect(new Ray(new Point3D(3.0000001, 5, 3), -Vector3D.UnitY), s_infinity, out _));
    }

    [Fact]
    public void Triangle_VertexData_IsInterpolated()
    {
        Triangle triangle = new(new Point3D(0, 0, 0), new Point3D(4, 0, 0), new Point3D(0, 4, 0))
        {
            VertexCoordinates = [new(0, 0), new(2, 0), new(0, 3)],
            VertexNormals = [new(0, 0, 1), new(0.6, 0, 0.8), new(0, 0, 5)],
        };
        Ray ray = new(new Point3D(1, 2, 7), -Vector3D.UnitZ);
        Assert.True(triangle.Intersect(ray, s_infinity, out Hit hit));
        SurfacePoint s = triangle.SurfaceAt(ray, hit);
        Assert.Equal(7, hit.T);
        Assert.Equal(new TextureCoordinate(0.5, 1.5), triangle.DefaultMapping.Map(s.Position));
        Assert.Equal(Vector3D.UnitZ, s.Normal);
        Assert.Equal(0, (s.ShadingNormal - new Vector3D(0.15, 0, 0.95).Normalized()).Length, 1e-15);
    }

    [Theory, MemberData(nameof(Kinds))]
    public void Intersect_DegenerateRays_NeverGiveNaN(string kind)
    {
        ShapeCases cases = new(9);
        Shape shape = cases.Create(kind, new Point3D(1, 2, 3), 1);
        double[] numbers = [0, -0.0, 1, -1, 1e-300, 1e-160, 1e150, -1e100, 3, 2, 1.5];
        Random random = new(4);
        double Any() => numbers[random.Next(numbers.Length)];
        for (int i = 0; i < 20000; i++)
        {
            Ray ray = new(new Point3D(Any(), Any(), Any()), new Vector3D(Any(), Any(), Any()));
            if (shape.Intersect(ray, s_infinity, out Hit hit))
            {
                Assert.True(hit.T > 0 && double.IsFinite(hit.T), $"{ray}: {hit.T}");
                SurfacePoint s = shape.SurfaceAt(ray, hit);
                Assert.True(s.Point.IsFinite && s.Normal.IsFinite && s.ShadingNormal.IsFinite && s.Position.LocalPoint.IsFinite, $"{ray}: {s}");
            }
        }
    }

    [Fact]
    public void Constructor_DegenerateArguments_SaysWhatIsAllowed()
    {
        Point3D nowhere = new(double.NaN, 0, 0);
        Refuses("finite", () => new Sphere(nowhere));
        Refuses("above 0", () => new Sphere(radius: 0));
        Refuses("finite", () => new Cylinder(nowhere));
        Refuses("above 0", () => new Cylinder(radius: -1));
        Refuses("above 0", () => new Cylinder(height: s_infinity));
        Refuses("length above 0", () => new Disk(Point3D.Origin, Vector3D.Zero));
        Refuses("above 0", () => new Disk(Point3D.Origin, Vector3D.UnitX, double.NaN));
        Refuses("parallel", () => new Quad(Point3D.Origin, Vector3D.UnitX, -2 * Vector3D.UnitX));
        Refuses("finite", () => new Quad(nowhere, Vector3D.UnitX, Vector3D.UnitY));
        Refuses("differ in x, y and z", () => new Box(Point3D.Origin, new Point3D(1, 0, 1)));
        Refuses("one line", () => new Triangle(Point3D.Origin, new Point3D(1, 1, 1), new Point3D(3, 3, 3)));
        Refuses("three", () => new Triangle(Point3D.Origin, new Point3D(1, 0, 0), new Point3D(0, 1, 0)) { VertexNormals = [Vector3D.UnitZ] });
        Refuses("three finite", () => new Triangle(Point3D.Origin, new Point3D(1, 0, 0), new Point3D(0, 1, 0)) { VertexCoordinates = [] });
    }

    [Theory, MemberData(nameof(Kinds))]
    public void Bounds_PointsOfTheSurface_AreInside(string kind)
    {
        ShapeCases cases = new(21);
        for (int i = 0; i < 1000; i++)
        {
            Shape shape = cases.Create(kind, new Point3D(1, 2, 3), 1.7);
            Ray ray = cases.RayAt(new Point3D(1, 2, 3), 1.7, Transform.Identity);
            if (shape.Intersect(ray, s_infinity, out Hit hit))
            {
                Point3D p = shape.SurfaceAt(ray, hit).Point;
                Bounds b = shape.Bounds;
                Assert.True(p.X >= b.Min.X && p.Y >= b.Min.Y && p.Z >= b.Min.Z && p.X <= b.Max.X && p.Y <= b.Max.Y && p.Z <= b.Max.Z);
            }
        }
    }

    private static void Refuses(string words, Func<Shape> make) => Assert.Contains(words, Assert.ThrowsAny<ArgumentException>(make).Message, StringComparison.Ordinal);
}
