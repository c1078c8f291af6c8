namespace LabRaytracer.Tests.Geometry;

/// <summary>Rays of which bounds are known beforehand meet what they would meet one by one.</summary>
public unsafe class KnownBoundsTests
{
    private const int Size = 400, Side = 16;

    [Theory, InlineData(1), InlineData(2), InlineData(60)]
    public void Nearest_CameraRaysWithBounds_FindsWhatALoopFinds(int objects) => new CameraRays(objects).RunAllDoubles();

    private static (Shape Shape, Transform Transform)[] Spheres(Random random, int count) =>
        [.. Enumerable.Range(0, count).Select(_ => ((Shape)new Sphere(Point(random, 8), 0.05 + random.NextDouble()), Transform.Identity))];

    private static Point3D Point(Random random, double size) =>
        new(size * (random.NextDouble() - 0.5), size * (random.NextDouble() - 0.5), size * (random.NextDouble() - 0.5));

    private sealed class CameraRays(int objects) : ILaneTest
    {
        public void Run<R, F, I>()
            where R : unmanaged, ILane<R, F, I>
            where F : unmanaged, ILane<F, F, I>
            where I : unmanaged, IIndexLane<I>
        {
            Random random = new(3);
            using LaneMemory memory = new();
            RayBatch<R, F, I> rays = new(memory, Side * Side);
            HitBatch<R, F, I> hits = new(memory, Side * Side), looped = new(memory, Side * Side);
            rays.Count = Side * Side;
            int found = 0;
            for (int turn = 0; turn < 60; turn++)
            {
                using BvhSceneRun<R, F, I> run = new(Spheres(random, objects));
                PerspectiveCamera camera = new(Point(random, 30), Point(random, 3), 10 + (100 * random.NextDouble()));
                Aim(rays, camera, random.Next(Size - Side), random.Next(Size - Side));
                rays.Renew();
                hits.Clear(rays);
                run.Tree.Nearest(rays, hits, 0, rays.Packets);
                rays.Narrow();
                looped.Clear(rays);
                run.NearestByLoop(rays, looped);
                Assert.Equal(Doubles(looped.T, rays.Count), Doubles(hits.T, rays.Count));
                Assert.Equal(new ReadOnlySpan<int>(looped.Object, rays.Count).ToArray(), new ReadOnlySpan<int>(hits.Object, rays.Count).ToArray());
                found += new ReadOnlySpan<int>(hits.Object, rays.Count).Count(0) < rays.Count ? 1 : 0;
            }

            Assert.True(found > 0);
        }

        private static void Aim<R, F, I>(RayBatch<R, F, I> rays, PerspectiveCamera camera, int left, int top)
            where R : unmanaged, ILane<R, F, I>
            where F : unmanaged, ILane<F, F, I>
            where I : unmanaged, IIndexLane<I>
        {
            for (int i = 0; i < rays.Count; i++)
            {
                rays.Set(i, camera.RayAt(left + (i % Side), top + (i / Side), Size, Size));
                R.Put(rays.Limit, i, double.PositiveInfinity);
            }

            int bundle = RayBatch<R, F, I>.BundlePackets * R.Width;
            rays.Bounds = new RayBounds[((rays.Count - 1) / bundle) + 1];
            for (int k = 0; k < rays.Bounds.Length; k++)
            {
                int first = k * bundle / Side, last = Math.Min(((k + 1) * bundle) - 1, rays.Count - 1) / Side;
                rays.Bounds[k] = ((IWideCamera)camera).Bounds(left, left + Side - 1, top + first, top + last, Size, Size)!.Value;
            }
        }

        private static double[] Doubles<R>(R* column, int count)
            where R : unmanaged, IReal<R> => [.. Enumerable.Range(0, count).Select(i => Lane.Take(column, i))];
    }
}
