namespace LabRaytracer.Tests;

/// <summary>The top-level tree must give what a loop over all objects gives, bit for bit.</summary>
public unsafe class BvhSceneTests
{
    [Theory]
    [InlineData(3)]
    [InlineData(60)]
    public void Nearest_ObjectsOfManyKinds_MatchesLoop(int count)
    {
        AssertMatches<Double8, Float8, Int8>(count);
        AssertMatches<Double1, Float1, Int1>(count);
        AssertMatches<Float16, Float16, Int16>(count);
    }

    [Fact]
    public void Nearest_EqualSpheres_SmallestNumberWins()
    {
        (Shape, Transform)[] objects = [.. Enumerable.Repeat(((Shape)new Sphere(), Transform.Identity), 20)];
        Ray[] rays = MeshSamples.Rays(100, Vector3D.Zero, 3, 31);
        using LaneMemory memory = new();
        using BvhSceneRun<Double16, Float16, Int16> run = new(objects);
        using MeshHits<Double16, Float16, Int16> found = new(rays);
        run.Tree.Nearest(found.Rays, found.Hits, 0, found.Rays.Packets);
        int[] numbers = [.. Enumerable.Range(0, rays.Length).Select(i => ((int*)found.Hits.Object)[i]).Distinct().Order()];
        Assert.Equal([0, HitBatch<Double16, Float16, Int16>.Miss], numbers);
    }

    private static void AssertMatches<R, F, I>(int count)
        where R : unmanaged, ILane<R, F, I>
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I>
    {
        Ray[] rays = [.. MeshSamples.Rays(500, Vector3D.Zero, 4, 32).Select(ray => new Ray(ray.Origin, ray.Direction.Normalized()))];
        using BvhSceneRun<R, F, I> run = new(Objects(count));
        using MeshHits<R, F, I> expected = new(rays), actual = new(rays);
        run.NearestByLoop(expected.Rays, expected.Hits);
        run.Tree.Nearest(actual.Rays, actual.Hits, 0, actual.Rays.Packets);
        int hits = 0;
        for (int i = 0; i < rays.Length; i++)
        {
            Assert.Equal(((int*)expected.Hits.Object)[i], ((int*)actual.Hits.Object)[i]);
            Assert.Equal(R.Take(expected.Hits.T, i), R.Take(actual.Hits.T, i));
            hits += ((int*)actual.Hits.Object)[i] == HitBatch<R, F, I>.Miss ? 0 : 1;
        }

        Assert.True(hits > 100);
        AssertBlocks(run, rays);
    }

    private static void AssertBlocks<R, F, I>(BvhSceneRun<R, F, I> run, Ray[] rays)
        where R : unmanaged, ILane<R, F, I>
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I>
    {
        using MeshHits<R, F, I> expected = new(rays, 2), actual = new(rays, 2);
        run.BlockByLoop(expected.Rays);
        run.Tree.Block(actual.Rays, 0, actual.Rays.Packets);
        for (int i = 0; i < rays.Length; i++)
        {
            Assert.Equal(R.Take(expected.Rays.Limit, i), R.Take(actual.Rays.Limit, i));
        }
    }

    /// <summary>Small spheres, meshes moved about, and a plane, which no tree can hold.</summary>
    private static (Shape, Transform)[] Objects(int count)
    {
        Random random = new(33);
        TriangleMesh mesh = MeshSamples.BumpyBall(1, 34, out _, out _);
        List<(Shape, Transform)> objects = [(new InfinitePlane(new Point3D(0, -3, 0), Vector3D.UnitY), Transform.Identity)];
        for (int i = 1; i < count; i++)
        {
            Vector3D place = MeshSamples.Inside(random) * 1.5;
            Transform moved = Transform.Scaling(new Vector3D(0.2, 0.3, 0.25)).Then(Transform.Translation(place));
            objects.Add(i % 3 == 0 ? (mesh, moved) : (new Sphere(Point3D.Origin + place, 0.25), Transform.Identity));
        }

        return [.. objects];
    }
}
