namespace LabRaytracer.Tests;

/// <summary>The tree must find what a loop over all triangles finds, bit for bit, at every width and precision.</summary>
public class BvhTests
{
    [Theory]
    [InlineData(1, 0.5, 0)]
    [InlineData(7, 0.5, 0)]
    [InlineData(300, 0.2, 0)]
    [InlineData(300, 0.01, 0)]
    [InlineData(300, 0.2, 1e6)]
    public void Nearest_RandomSoup_MatchesLoopAtEveryWidth(int triangles, double size, double offset)
    {
        Vector3D place = new(offset, -2 * offset, 0.5 * offset);
        TriangleMesh mesh = MeshSamples.Soup(triangles, size, place, 1);
        Ray[] rays = [.. MeshSamples.Rays(400, place, 3, 2), .. MeshSamples.Rays(200, place, 1, 3)];
        AssertMatches(mesh, rays);
    }

    [Fact]
    public void Nearest_AllCentersEqual_MatchesLoop()
    {
        List<Point3D> points = [];
        for (int i = 1; i <= 64; i++)
        {
            points.AddRange([new(-i, -i, i), new(i, 0, -i), new(0, i, 0)]);
            points.AddRange([new(-i, -i, -i), new(i, 0, i), new(0, i, 0)]);
        }

        AssertMatches(new TriangleMesh(points, MeshSamples.Numbers(points.Count)), MeshSamples.Rays(300, Vector3D.Zero, 80, 4));
    }

    [Fact]
    public void Nearest_RepeatedTriangle_SmallestNumberWins()
    {
        List<Point3D> points = [];
        for (int i = 0; i < 50; i++)
        {
            points.AddRange([new(-1, -1, 0), new(1, -1, 0), new(0, 1, 0)]);
        }

        TriangleMesh mesh = new(points, MeshSamples.Numbers(points.Count));
        Ray[] rays = [.. Enumerable.Range(0, 40).Select(i => new Ray(new Point3D(0.01 * i, -0.01 * i, 3), new Vector3D(0, 0, -1)))];
        Assert.All(MeshHits<Double16, Float16, Int16>.ByTree(mesh, rays), hit =>
        {
            Assert.Equal(0, hit.Part);
            Assert.Equal(3, hit.T, 1e-14);
        });
    }

    [Theory]
    [InlineData(0)]
    [InlineData(1)]
    [InlineData(2)]
    public void Nearest_FlatGrid_RaysAlongFacesAndThroughVertices(int axis)
    {
        TriangleMesh mesh = Grid(axis, 8);
        List<Ray> rays = [];
        for (int i = 0; i <= 16; i++)
        {
            for (int k = 0; k <= 16; k++)
            {
                Vector3D inPlane = Turned(axis, i / 2.0, k / 2.0, 0);
                rays.Add(new Ray(Point3D.Origin + inPlane + Turned(axis, 0, 0, 2), Turned(axis, 0, 0, -1)));
                rays.Add(new Ray(Point3D.Origin + inPlane + Turned(axis, 0, 0, -2), Turned(axis, 0.0, -0.0, 1)));
                rays.Add(new Ray(Point3D.Origin + Turned(axis, -1, k / 2.0, 0), Turned(axis, 1, 0, 0)));
            }
        }

        Ray[] all = [.. rays];
        AssertMatches(mesh, all);
        MeshHit[] hits = MeshHits<Double8, Float8, Int8>.ByTree(mesh, all);
        Assert.Equal(2 * 17 * 17, hits.Count(hit => hit.T == 2));
    }

    [Fact]
    public void Block_AnyLimit_AgreesWithNearest()
    {
        TriangleMesh mesh = MeshSamples.Soup(200, 0.3, Vector3D.Zero, 5);
        Ray[] rays = MeshSamples.Rays(600, Vector3D.Zero, 2, 6);
        foreach (double limit in new[] { 0.05, 1, 30, double.PositiveInfinity })
        {
            bool[] expected = [.. MeshHits<Double8, Float8, Int8>.ByLoop(mesh, rays, limit).Select(hit => hit.T > 0)];
            Assert.Equal(expected, MeshHits<Double16, Float16, Int16>.Blocked(mesh, rays, limit));
            Assert.Equal(expected, MeshHits<Double1, Float1, Int1>.Blocked(mesh, rays, limit));
        }
    }

    [Fact]
    public void Nearest_AnyThreadCount_GivesTheSameTree()
    {
        using Bvh one = Tree(1, out int[] order);
        for (int threads = 2; threads <= 4; threads++)
        {
            using Bvh many = Tree(threads, out int[] sameOrder);
            AssertSameTree(one, many);
            Assert.Equal(order, sameOrder);
        }
    }

    [Fact]
    public void Nearest_RaysThatAreNotFinite_HitNothing()
    {
        TriangleMesh mesh = MeshSamples.Soup(100, 0.5, Vector3D.Zero, 7);
        double[] bad = [double.NaN, double.PositiveInfinity, double.NegativeInfinity];
        List<Ray> rays = [new(Point3D.Origin, Vector3D.Zero)];
        foreach (double number in bad)
        {
            rays.Add(new Ray(new Point3D(number, 0, 0), new Vector3D(0, 0, 1)));
            rays.Add(new Ray(new Point3D(0, number, number), new Vector3D(1, 1, 1)));
            rays.Add(new Ray(Point3D.Origin, new Vector3D(number, 0, 1)));
            rays.Add(new Ray(Point3D.Origin, new Vector3D(0, number, 0)));
        }

        Ray[] all = [.. rays];
        Assert.All(MeshHits<Double8, Float8, Int8>.ByTree(mesh, all), hit => Assert.Equal(default, hit));
        Assert.All(MeshHits<Float4, Float4, Int4>.ByTree(mesh, all), hit => Assert.Equal(default, hit));
        Assert.All(all, ray => Assert.False(mesh.Intersect(ray, double.PositiveInfinity, out _)));
    }

    private static void AssertMatches(TriangleMesh mesh, Ray[] rays)
    {
        MeshHit[] doubles = MeshHits<Double8, Float8, Int8>.ByLoop(mesh, rays);
        Assert.Equal(doubles, MeshHits<Double16, Float16, Int16>.ByTree(mesh, rays));
        Assert.Equal(doubles, MeshHits<Double8, Float8, Int8>.ByTree(mesh, rays));
        Assert.Equal(doubles, MeshHits<Double4, Float4, Int4>.ByTree(mesh, rays));
        Assert.Equal(doubles, MeshHits<Double1, Float1, Int1>.ByTree(mesh, rays));
        MeshHit[] floats = MeshHits<Float8, Float8, Int8>.ByLoop(mesh, rays);
        Assert.Equal(floats, MeshHits<Float16, Float16, Int16>.ByTree(mesh, rays));
        Assert.Equal(floats, MeshHits<Float8, Float8, Int8>.ByTree(mesh, rays));
        Assert.Equal(floats, MeshHits<Float4, Float4, Int4>.ByTree(mesh, rays));
        Assert.Equal(floats, MeshHits<Float1, Float1, Int1>.ByTree(mesh, rays));
        Assert.Equal(doubles, rays.Select(ray => mesh.Intersect(ray, double.PositiveInfinity, out Hit hit) ? new MeshHit(hit.T, hit.Part, hit.A, hit.B) : default));
    }

    /// <summary>Squares of two triangles in the plane through 0 across an axis; corners at the integers 0 to size.</summary>
    private static TriangleMesh Grid(int axis, int size)
    {
        List<Point3D> points = [];
        List<int> corners = [];
        for (int i = 0; i <= size; i++)
        {
            for (int k = 0; k <= size; k++)
            {
                points.Add(Point3D.Origin + Turned(axis, i, k, 0));
                if (i < size && k < size)
                {
                    int at = (i * (size + 1)) + k;
                    corners.AddRange([at, at + 1, at + size + 1, at + 1, at + size + 2, at + size + 1]);
                }
            }
        }

        return new TriangleMesh(points, corners.ToArray());
    }

    private static Vector3D Turned(int axis, double a, double b, double across) =>
        axis == 0 ? new Vector3D(across, a, b) : axis == 1 ? new Vector3D(b, across, a) : new Vector3D(a, b, across);

    private static Bvh Tree(int threads, out int[] order) => Bvh.Build(new BvhBounds(Random(40000)), new BvhCost(1, 4), threads, out order);

    private static Bounds[] Random(int count)
    {
        Random random = new(8);
        return [.. Enumerable.Range(0, count).Select(_ => Point3D.Origin + MeshSamples.Inside(random)).Select(p => new Bounds(p, p + new Vector3D(0.01, 0.01, 0.01)))];
    }

    private static unsafe void AssertSameTree(Bvh expected, Bvh actual)
    {
        Assert.Equal(expected.NodeCount, actual.NodeCount);
        int bytes = expected.NodeCount * sizeof(BvhNode);
        Assert.True(new ReadOnlySpan<byte>(expected.Nodes, bytes).SequenceEqual(new ReadOnlySpan<byte>(actual.Nodes, bytes)));
    }
}
