namespace LabRaytracer.Tests;

/// <summary>A group of several meshes, some rays on each in the same group of lanes.</summary>
internal static unsafe class MeshTwoMeshes
{
    public static void AssertSurfaces<R, F, I>(TriangleMesh[] meshes, Transform[] transforms)
        where R : unmanaged, ILane<R, F, I>
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I>
    {
        Ray[] rays = [.. Enumerable.Range(0, 64).Select(i => new Ray(new Point3D((i % 16 * 0.25) - 2.5, (i / 16 * 0.3) + 0.1, 4), new Vector3D(0.01, 0.02, -1)))];
        using LaneMemory memory = new();
        using MeshHits<R, F, I> run = new(rays);
        ShapeGroup<R, F, I> group = meshes[0].CreateGroup<R, F, I>(transforms[0]);
        int* members = memory.Column<int>(meshes.Length, 1);
        for (int i = 0; i < meshes.Length; i++)
        {
            members[i] = group.Add(meshes[i], transforms[i], i);
        }

        group.Freeze(memory, 1);
        for (int i = 0; i < meshes.Length; i++)
        {
            group.Nearest(members[i], run.Rays, run.Hits, 0, run.Rays.Packets);
        }

        int[] hitRays = [.. Enumerable.Range(0, rays.Length).Where(ray => ((int*)run.Hits.Object)[ray] != HitBatch<R, F, I>.Miss)];
        Assert.True(hitRays.Select(ray => ((int*)run.Hits.Object)[ray]).Distinct().Count() == meshes.Length);
        int* order = memory.Column<int>(hitRays.Length + R.Width, 1);
        for (int i = 0; i < hitRays.Length + R.Width; i++)
        {
            order[i] = hitRays[Math.Min(i, hitRays.Length - 1)];
        }

        SurfaceBatch<R, F, I> surfaces = new(memory, rays.Length + R.Width);
        SurfaceNeeds all = SurfaceNeeds.LocalPoint | SurfaceNeeds.LocalNormal | SurfaceNeeds.SurfaceCoordinates | SurfaceNeeds.Parameter;
        group.Surface(run.Rays, run.Hits, order, hitRays.Length, members, surfaces, all);
        for (int i = 0; i < hitRays.Length; i++)
        {
            AssertSurface(meshes, transforms, rays[hitRays[i]], run, hitRays[i], surfaces, i);
        }
    }

    private static void AssertSurface<R, F, I>(
        TriangleMesh[] meshes, Transform[] transforms, Ray ray, MeshHits<R, F, I> run, int number, SurfaceBatch<R, F, I> surfaces, int element)
        where R : unmanaged, ILane<R, F, I>
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I>
    {
        int owner = ((int*)run.Hits.Object)[number];
        Ray local = transforms[owner].ObjectFromWorld(ray);
        Hit hit = new(R.Take(run.Hits.T, number), ((int*)run.Hits.Part)[number], R.Take(run.Hits.A, number), R.Take(run.Hits.B, number));
        SurfacePoint expected = meshes[owner].SurfaceAt(local, hit);
        Point3D world = transforms[owner].WorldFromObject(expected.Point);
        Assert.Equal(world.X, R.Take(surfaces.PointX, element), 1e-14);
        Assert.Equal(world.Y, R.Take(surfaces.PointY, element), 1e-14);
        Assert.Equal(world.Z, R.Take(surfaces.PointZ, element), 1e-14);
        Assert.Equal(expected.Position.LocalPoint.X, R.Take(surfaces.Positions.X, element));
        Assert.Equal(expected.Position.LocalNormal.Z, R.Take(surfaces.Positions.NormalZ, element));
        Assert.Equal(expected.Position.Surface.U, R.Take(surfaces.Positions.SurfaceU, element));
        Assert.Equal(expected.Position.Surface.V, R.Take(surfaces.Positions.SurfaceV, element));
        Vector3D fromRay = (ray.Origin + (ray.Direction * hit.T)) - world;
        Assert.True(fromRay.Length < 1e-13);
        Assert.InRange(R.Take(surfaces.Slack, element), 1e-16, 1e-13);
    }
}
