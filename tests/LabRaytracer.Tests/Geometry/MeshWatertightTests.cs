namespace LabRaytracer.Tests;

/// <summary>Rays from inside a closed mesh must hit it, wherever they aim.</summary>
public class MeshWatertightTests
{
    [Fact]
    public void Nearest_AimedAtVerticesAndEdgesFromInside_NeverEscapes()
    {
        TriangleMesh mesh = MeshSamples.BumpyBall(3, 11, out Point3D[] vertices, out int[] corners);
        Assert.True(mesh.TriangleCount >= 1280);
        Ray[] rays = AimedRays(vertices, corners, Vector3D.Zero);
        Assert.True(rays.Length >= 5000);
        Assert.All(MeshHits<Double16, Float16, Int16>.ByTree(mesh, rays), hit => Assert.True(hit.T > 0));
        Assert.All(MeshHits<Float16, Float16, Int16>.ByTree(mesh, rays), hit => Assert.True(hit.T > 0));
    }

    [Fact]
    public void Nearest_ThroughATransform_NeverEscapes()
    {
        TriangleMesh mesh = MeshSamples.BumpyBall(3, 12, out Point3D[] vertices, out int[] corners);
        Vector3D offset = new(100, 20, -30);
        Transform transform = Transform.Scaling(new Vector3D(1, 2, 0.5)).Then(Transform.Rotation(new Vector3D(1, 2, 3), 40)).Then(Transform.Translation(offset));
        Ray[] rays = [.. AimedRays(vertices, corners, Vector3D.Zero).Select(ray => new Ray(transform.WorldFromObject(ray.Origin), transform.WorldFromObject(ray.Direction)))];
        Assert.All(MeshHits<Double8, Float8, Int8>.ByTree(mesh, rays, transform: transform), hit => Assert.True(hit.T > 0));
        Assert.All(MeshHits<Float8, Float8, Int8>.ByTree(mesh, rays, transform: transform), hit => Assert.True(hit.T > 0));
    }

    [Theory]
    [InlineData(1e-8, 0)]
    [InlineData(1e8, 0)]
    [InlineData(1, 1e6)]
    public void Nearest_OtherScalesAndPlaces_NeverEscapes(double scale, double offset)
    {
        MeshSamples.BumpyBall(3, 15, out Point3D[] vertices, out int[] corners);
        Vector3D place = new(offset, -offset, 0.5 * offset);
        Point3D[] moved = [.. vertices.Select(vertex => Point3D.Origin + (vertex.ToVector() * scale) + place)];
        Ray[] rays = [.. AimedRays(vertices, corners, Vector3D.Zero)
            .Select(ray => new Ray(Point3D.Origin + (ray.Origin.ToVector() * scale) + place, ray.Direction))];
        TriangleMesh mesh = new(moved, corners);
        Assert.All(MeshHits<Double16, Float16, Int16>.ByTree(mesh, rays), hit => Assert.True(hit.T > 0));
        if (offset == 0)
        {
            Assert.All(MeshHits<Float16, Float16, Int16>.ByTree(mesh, rays), hit => Assert.True(hit.T > 0));
        }
    }

    [Theory]
    [InlineData(1e-6)]
    [InlineData(1e-9)]
    [InlineData(1e-12)]
    public void Intersect_SliverOfThisWidth_IsHitInItsMiddle(double width)
    {
        Point3D[] vertices = [new(-1, 0, 0), new(1, 0, 0), new(0, width, 0)];
        TriangleMesh mesh = new(vertices, [0, 1, 2]);
        Ray ray = new(new Point3D(0.1, 0.25 * width, 1), new Vector3D(0, 0, -1));
        Assert.True(mesh.Intersect(ray, 2, out Hit hit));
        Assert.Equal(1, hit.T, 1e-14);
        Assert.Equal(0.25, hit.B, 1e-12);
        SurfacePoint surface = mesh.SurfaceAt(ray, hit);
        Assert.Equal(new Vector3D(0, 0, 1), surface.Normal);
    }

    [Fact]
    public void Nearest_SharedEdgeSeenFromFar_NoGap()
    {
        Point3D[] vertices = [new(0, 0, 0), new(1, 0.1, 0), new(0.3, 1, 0.2), new(-0.7, 0.6, 0.1)];
        TriangleMesh mesh = new(vertices, [0, 1, 2, 0, 2, 3]);
        Random random = new(13);
        Ray[] rays = new Ray[3000];
        for (int i = 0; i < rays.Length; i++)
        {
            Point3D onEdge = Point3D.Origin + (new Vector3D(0.3, 1, 0.2) * (0.01 + (0.98 * random.NextDouble())));
            Point3D origin = Point3D.Origin + (MeshSamples.Inside(random) * 1000) + new Vector3D(0, 0, 2000);
            rays[i] = new Ray(origin, onEdge - origin);
        }

        Assert.All(MeshHits<Double16, Float16, Int16>.ByTree(mesh, rays), hit => Assert.True(hit.T > 0));
        Assert.All(MeshHits<Float16, Float16, Int16>.ByTree(mesh, rays), hit => Assert.True(hit.T > 0));
    }

    /// <summary>Rays to all vertices, and to points of all edges, from random places near the middle.</summary>
    private static Ray[] AimedRays(Point3D[] vertices, int[] corners, Vector3D offset)
    {
        Random random = new(14);
        List<Ray> rays = [];
        void Aim(Point3D target)
        {
            Point3D origin = Point3D.Origin + offset + (MeshSamples.Inside(random) * 0.3);
            rays.Add(new Ray(origin, target + offset - origin));
        }

        foreach (Point3D vertex in vertices)
        {
            Aim(vertex);
            Aim(vertex);
        }

        for (int i = 0; i < corners.Length; i++)
        {
            Point3D from = vertices[corners[i]];
            Vector3D edge = vertices[corners[i % 3 == 2 ? i - 2 : i + 1]] - from;
            Aim(from + (edge * 0.5));
            Aim(from + (edge * random.NextDouble()));
        }

        return [.. rays];
    }
}
