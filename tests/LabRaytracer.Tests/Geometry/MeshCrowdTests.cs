namespace LabRaytracer.Tests;

/// <summary>Rays that go their own ways (<see cref="MeshCrowd"/>): the hits of the test of every triangle, bit for bit.</summary>
public class MeshCrowdTests
{
    // More than one room full of rays, and a last crowd that is not full.
    private const int Count = (2 * MeshCrowd.Most) + 45;

    public static TheoryData<double, double> Places => new()
    {
        // Scale of the mesh, its distance from the origin.
        { 1, 0 }, { 1, 1000 }, { 1e-9, 0 }, { 1e12, 0 }, { 1, 1e6 },
    };

    [Theory]
    [MemberData(nameof(Places))]
    public void Nearest_RaysFromSurfacePoints_SameBitsAsEveryTriangle(double scale, double offset)
    {
        TriangleMesh ball = Ball(scale, offset);
        MeshAssert.Nearest(ball, FromSurface(ball, Count, scale * 1e-6, 3));
    }

    [Theory]
    [InlineData(1e-5)]
    [InlineData(0.05)]
    [InlineData(1.5)]
    [InlineData(1000)]
    public void Nearest_SoupOfTriangles_SameBitsAsEveryTriangle(double size)
    {
        TriangleMesh soup = MeshSamples.Soup(300, size, new Vector3D(1, -2, 3), 5);
        MeshAssert.Nearest(soup, [.. MeshSamples.Rays(Count, new Vector3D(1, -2, 3), 3, 8), .. FromSurface(soup, Count, 0, 4)]);
    }

    [Fact]
    public void Nearest_SliversSeenFromTheirEdges_SameBitsAsEveryTriangle()
    {
        // Fans of triangles as thin as doubles allow, rays along their planes and along axes.
        List<Point3D> points = [];
        for (int i = 0; i < 60; i++)
        {
            double at = 0.1 * i, thin = Math.Pow(10, -i % 17);
            points.AddRange([new(at, 0, 0), new(at + 1, thin, 0), new(at + 1, 0, thin)]);
        }

        TriangleMesh mesh = new(points, MeshSamples.Numbers(points.Count), new MeshOptions { DegenerateTriangles = DegenerateTriangles.Drop });
        Random random = new(2);
        Ray[] rays = [.. Enumerable.Range(0, Count).Select(i => new Ray(
            points[random.Next(points.Count)] + (MeshSamples.Inside(random) * (i % 4 == 0 ? 0 : 1e-7)),
            i % 3 == 0 ? Vector3D.UnitX : i % 3 == 1 ? new Vector3D(1, 1e-9 * random.NextDouble(), 0) : MeshSamples.Inside(random)))];
        MeshAssert.Nearest(mesh, [.. rays, .. MeshSamples.Rays(Count, default, 3, 8)]);
    }

    [Fact]
    public void Nearest_SameTriangleTwice_SmallerNumberWins()
    {
        Point3D[] vertices = [new(-1, -1, 0), new(1, -1, 0), new(0, 1, 0)];
        TriangleMesh mesh = new([.. vertices, .. vertices, .. vertices], [3, 4, 5, 0, 1, 2, 6, 7, 8, 3, 4, 5, 6, 7, 8]);
        Random random = new(6);
        Ray[] rays = [.. Enumerable.Range(0, Count).Select(i =>
        {
            Point3D origin = new(random.NextDouble() - 0.5, 0.3 * random.NextDouble(), 3 + random.NextDouble());
            return new Ray(origin, (new Point3D(-0.4 + (0.001 * i), -0.3, 0) - origin).Normalized());
        })];
        MeshAssert.Nearest(mesh, rays);
        Assert.All(MeshHits<Double16, Float16, Int16>.ByTree(mesh, rays), hit => Assert.Equal(0, hit.Part));
    }

    [Theory]
    [MemberData(nameof(Places))]
    public void Block_RaysFromSurfacePoints_SameAsEveryTriangleButTheirOwn(double scale, double offset)
    {
        TriangleMesh ball = Ball(scale, offset);
        Random random = new(9);
        Ray[] rays = FromSurface(ball, Count, 0, 7);
        int[] sources = [.. rays.Select((_, i) => i % 3 == 0 ? -1 : i % ball.TriangleCount)];

        // Off alone, in whole groups of lanes, and in a whole crowd.
        double[] limits = [.. rays.Select((_, i) => i % 7 == 6 || i / 16 % 5 == 3 || i / BvhCrowd.Most == 2 ? -1 : scale * 2 * random.NextDouble())];
        Assert.Contains(true, MeshAssert.Blocked(ball, rays, limits, sources));
    }

    private static TriangleMesh Ball(double scale, double offset)
    {
        MeshSamples.BumpyBall(2, 21, out Point3D[] unit, out int[] corners);
        Vector3D middle = new Vector3D(1, -0.5, 0.25) * (offset * scale);
        return new TriangleMesh([.. unit.Select(vertex => Point3D.Origin + middle + (vertex.ToVector() * scale))], corners);
    }

    /// <summary>Rays from points on triangles, some of them beside, in all directions.</summary>
    private static Ray[] FromSurface(TriangleMesh mesh, int count, double beside, int seed)
    {
        Random random = new(seed);
        Ray[] rays = new Ray[count];
        for (int i = 0; i < count; i++)
        {
            int triangle = i % mesh.TriangleCount;
            Point3D a = mesh.Data.Position(triangle, 0);
            Point3D origin = a + ((mesh.Data.Position(triangle, 1) - a) * 0.3) + ((mesh.Data.Position(triangle, 2) - a) * (0.6 * random.NextDouble()));
            Vector3D direction = i % 5 == 0 ? mesh.Data.Position(random.Next(mesh.TriangleCount), 1) - origin : MeshSamples.Inside(random);
            rays[i] = new Ray(origin + (MeshSamples.Inside(random) * beside), direction);
        }

        return rays;
    }
}
