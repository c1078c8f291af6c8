namespace LabRaytracer.Tests;

/// <summary>Rays through one point (<see cref="MeshPencil"/>): the hits of the test of every triangle, bit for bit.</summary>
public class MeshPencilTests
{
    private const int Together = 64;

    public static TheoryData<double, double, double> Places => new()
    {
        // Scale of the mesh, its distance from the origin, distance of the apex from its middle in radii.
        { 1, 0, 4 }, { 1, 0, 0.3 }, { 1, 0, 1 }, { 1, 1000, 4 }, { 1, 0, 1000 }, { 1, 1e6, 3 }, { 1e-4, 0, 3 }, { 1e6, 0, 3 }, { 1e-9, 0, 3 }, { 1e12, 0, 3 },
    };

    [Theory]
    [MemberData(nameof(Places))]
    public void Nearest_RaysFromOnePoint_SameBitsAsEveryTriangle(double scale, double offset, double distance)
    {
        TriangleMesh ball = Ball(scale, offset, out Point3D[] vertices, out int[] corners);
        foreach (Vector3D towards in (Vector3D[])[new(0.3, 0.5, 0.8), new(-1, 0.01, 0.02), new(0, -1, 0)])
        {
            Point3D apex = Middle(scale, offset) + (towards.Normalized() * (distance * scale));
            Ray[] rays = [.. Targets(vertices, corners, 15).Select(target => new Ray(apex, (target - apex).Normalized()))];
            AssertNearest(ball, rays);
        }
    }

    [Theory]
    [MemberData(nameof(Places))]
    public void Block_RaysToOnePoint_SameAsEveryTriangle(double scale, double offset, double distance)
    {
        TriangleMesh ball = Ball(scale, offset, out Point3D[] vertices, out int[] corners);
        Point3D lamp = Middle(scale, offset) + (new Vector3D(0.3, -0.4, 0.8).Normalized() * (distance * scale));
        AssertBlocked(ball, Targets(vertices, corners, 30), lamp);
    }

    [Fact]
    public void Nearest_ApexInThePlanesOfTriangles_SameBits()
    {
        // Every triangle of this fan, and its mirror image, contains the apex or lies in a plane with it.
        List<Point3D> points = [];
        for (int i = 0; i < 40; i++)
        {
            double angle = 0.11 * i;
            points.AddRange([new(Math.Cos(angle), Math.Sin(angle), 2), new(2 * Math.Cos(angle), 2 * Math.Sin(angle), 4), new(Math.Cos(angle + 1e-3), Math.Sin(angle + 1e-3), 3 + i)]);
        }

        points.AddRange([new(-90, -90, 50), new(90, -90, 50), new(0, 90, 50)]);
        TriangleMesh mesh = new(points, MeshSamples.Numbers(points.Count));
        Ray[] rays = [.. Targets([.. points], MeshSamples.Numbers(points.Count), 15).Select(target => new Ray(Point3D.Origin, (target - Point3D.Origin).Normalized()))];
        AssertNearest(mesh, rays);
    }

    [Fact]
    public void NearestAndBlock_RaysToBothSidesOfTheApex_Same()
    {
        // All largest along one axis, half of them the other way: no pencil.
        TriangleMesh ball = Ball(1, 0, out _, out _);
        Random random = new(3);
        foreach (int axis in (int[])[0, 1, 2])
        {
            Point3D apex = new(0.1, -0.2, 0.05);
            Vector3D[] directions = [.. Enumerable.Range(0, 160).Select(i => Turned(axis, i % 2 == 0 ? 1 : -1, 0.4 * random.NextDouble(), -0.4 * random.NextDouble()).Normalized())];
            AssertNearest(ball, [.. directions.Select(direction => new Ray(apex, direction))]);
            AssertBlocked(ball, [.. directions.Select((direction, i) => apex + (direction * (0.5 + (0.01 * i))))], apex);
        }
    }

    [Fact]
    public void Nearest_SameTriangleTwice_SmallerNumberWins()
    {
        Point3D[] vertices = [new(-1, -1, 0), new(1, -1, 0), new(0, 1, 0)];
        TriangleMesh mesh = new([.. vertices, .. vertices, .. vertices], [3, 4, 5, 0, 1, 2, 6, 7, 8, 3, 4, 5, 6, 7, 8]);
        Point3D apex = new(0.1, 0.2, 3);
        Ray[] rays = [.. Enumerable.Range(0, 64).Select(i => new Ray(apex, (new Point3D(-0.4 + (0.01 * i), -0.3, 0) - apex).Normalized()))];
        AssertNearest(mesh, rays);
        Assert.All(MeshHits<Double16, Float16, Int16>.ByTree(mesh, rays), hit => Assert.Equal(0, hit.Part));
    }

    [Theory]
    [InlineData(1e-5)]
    [InlineData(0.05)]
    [InlineData(1.5)]
    public void NearestAndBlock_SoupOfTriangles_Same(double size)
    {
        TriangleMesh soup = MeshSamples.Soup(400, size, new Vector3D(1, -2, 3), 5);
        Point3D[] vertices = [.. Enumerable.Range(0, 1200).Select(i => soup.Data.Position(i / 3, i % 3))];
        Point3D apex = new(1.5, -1, 6);
        Point3D[] targets = Targets(vertices, MeshSamples.Numbers(1200), 40);
        AssertNearest(soup, [.. targets.Select(target => new Ray(apex, (target - apex).Normalized()))]);
        AssertBlocked(soup, targets, apex);
    }

    [Theory]
    [InlineData(5)]
    [InlineData(0)]
    public void Block_SourceTriangle_DoesNotBlockItsOwnRays(double height)
    {
        // In the middle of the ball, rays come from all sides and are no pencil.
        // Points on triangles, rounded: many are on the lamp's far side of their own.
        TriangleMesh ball = Ball(1, 0, out Point3D[] vertices, out int[] corners);
        Point3D lamp = new(0.2, -0.1, height);
        Random random = new(29);
        int[] sources = [.. Enumerable.Range(0, 1600).Select(_ => random.Next(ball.TriangleCount))];
        Point3D[] origins = [.. sources.Select(triangle => ball.Data.Position(triangle, 0)
            + ((ball.Data.Position(triangle, 1) - ball.Data.Position(triangle, 0)) * 0.4) + ((ball.Data.Position(triangle, 2) - ball.Data.Position(triangle, 0)) * 0.3))];
        Ray[] rays = [.. origins.Select(origin => new Ray(origin, (lamp - origin).Normalized()))];
        double[] limits = [.. origins.Select(origin => (lamp - origin).Length)];
        Assert.NotEqual(MeshAssert.BlockedByLoop<Double1, Float1, Int1>(ball, rays, limits, null), MeshAssert.Blocked(ball, rays, limits, sources));
    }

    [Theory]
    [InlineData(false)]
    [InlineData(true)]
    public unsafe void Find_FloatLanes_ArePencils(bool endsAtApex)
    {
        // Else the search for rays of any kind would answer instead, and nothing here would be tested.
        TriangleMesh ball = Ball(1, 0, out Point3D[] vertices, out _);
        Point3D apex = new(0.4, -1.3, 5);
        Ray[] rays = [.. vertices.Take(Float16.Width).Select(vertex => endsAtApex ? new Ray(vertex, (apex - vertex).Normalized()) : new Ray(apex, (vertex - apex).Normalized()))];
        using MeshHits<Float16, Float16, Int16> run = new(rays);
        PencilLanes<Float16, Float16, Int16> lanes = new() { Ray = run.Rays.Load(0) };
        for (int i = 0; i < Float16.Width; i++)
        {
            Lane.Put(&lanes.Limit, i, endsAtApex ? (apex - vertices[i]).Length : double.PositiveInfinity);
        }

        SlopeBounds parts;
        Assert.True(PencilFinder.Find(&lanes, 1, ball.Tree(1).Frame, endsAtApex, &parts, out RayPencil pencil));
        Assert.Equal((2, -1.0), (pencil.Axis, pencil.Sign));
    }

    private static Vector3D Turned(int axis, double x, double y, double z) => axis == 0 ? new(x, y, z) : axis == 1 ? new(z, x, y) : new(y, z, x);

    private static Point3D Middle(double scale, double offset) => new(offset * scale, -0.5 * offset * scale, 0.25 * offset * scale);

    private static TriangleMesh Ball(double scale, double offset, out Point3D[] vertices, out int[] corners)
    {
        MeshSamples.BumpyBall(3, 21, out Point3D[] unit, out corners);
        vertices = [.. unit.Select(vertex => Middle(scale, offset) + (vertex.ToVector() * scale))];
        return new TriangleMesh(vertices, corners);
    }

    /// <summary>Groups of points, each around one triangle: its vertices and places on its edges exactly, close by, and inside.</summary>
    private static Point3D[] Targets(Point3D[] vertices, int[] corners, int groups)
    {
        Random random = new(17);
        List<Point3D> targets = [];
        for (int group = 0; group < groups; group++)
        {
            int first = 3 * random.Next(corners.Length / 3);
            Point3D a = vertices[corners[first]];
            Vector3D b = vertices[corners[first + 1]] - a, c = vertices[corners[first + 2]] - a;
            for (int i = 0; i < Together; i++)
            {
                (double u, double v) = i switch
                {
                    0 => (0, 0),
                    1 => (1, 0),
                    2 => (0, 1),
                    3 => (0.5, 0),
                    4 => (0, 0.5),
                    5 => (0.5, 0.5),
                    6 => (0.5, 1e-9),
                    7 => (-1e-9, 0.5),
                    8 => (1e-15, 0.25),
                    _ => ((1.4 * random.NextDouble()) - 0.2, (1.4 * random.NextDouble()) - 0.2),
                };
                targets.Add(a + (b * u) + (c * v));
            }
        }

        return [.. targets];
    }

    private static void AssertNearest(TriangleMesh mesh, Ray[] rays)
    {
        MeshHit[] expected = MeshAssert.Nearest(mesh, rays);

        // A limit among the hits.
        double limit = expected.Where(hit => hit.T > 0).Select(hit => hit.T).Order().ElementAt(expected.Count(hit => hit.T > 0) / 2);
        Assert.Equal(MeshHits<Double1, Float1, Int1>.ByLoop(mesh, rays, limit), MeshHits<Double8, Float8, Int8>.ByTree(mesh, rays, limit));
        Assert.Equal(MeshHits<Float1, Float1, Int1>.ByLoop(mesh, rays, limit), MeshHits<Float8, Float8, Int8>.ByTree(mesh, rays, limit));
    }

    private static void AssertBlocked(TriangleMesh mesh, Point3D[] origins, Point3D lamp)
    {
        Ray[] rays = [.. origins.Select(origin => new Ray(origin, (lamp - origin).Normalized()))];
        double[] limits = [.. origins.Select((origin, i) => i % 5 == 4 ? -1 : (lamp - origin).Length)];
        Assert.Contains(true, MeshAssert.Blocked(mesh, rays, limits, null));
    }
}
