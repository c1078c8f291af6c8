namespace LabRaytracer.Tests.Geometry;

/// <summary>The last digits of t are left out where nobody reads them; surface points do not depend on that.</summary>
public sealed class UnreadParameterTests
{
    [Fact]
    public void Surface_NobodyAsksForT_DoublesGiveTheSamePoints() => new Comparison().RunAllDoubles();

    [Fact]
    public void Surface_NobodyAsksForT_FloatsGiveTheSamePoints() => new Comparison().RunAllFloats();

    private sealed class Comparison : ILaneTest
    {
        private const int Count = 4000;

        public void Run<R, F, I>()
            where R : unmanaged, ILane<R, F, I>
            where F : unmanaged, ILane<F, F, I>
            where I : unmanaged, IIndexLane<I>
        {
            ShapeCases cases = new(5);
            Shape[] spheres = [new Sphere(new Point3D(3, -1, 2), 0.45), new Sphere(new Point3D(2.2, -1, 2.5), 0.45)];
            Ray[] rays = [.. Enumerable.Range(0, Count).Select(k => Start(cases, k))];
            using ShapeRun<R, F, I> asked = Hits<R, F, I>(spheres, rays), unasked = Hits<R, F, I>(spheres, rays);
            int[] hits = asked.Surface();
            Assert.Equal(hits, unasked.Surface(asksForT: false));
            Assert.InRange(hits.Length, Count / 4, Count);
            int rougher = 0;
            for (int i = 0; i < hits.Length; i++)
            {
                Assert.Equal(asked.SurfaceNumbers(i), unasked.SurfaceNumbers(i));
                rougher += asked.Distance(hits[i]) == unasked.Distance(hits[i]) ? 0 : 1;
            }

            // Else nothing was left out, and the test would say nothing. In float lanes, points of rays that start as near as these need the digits as well, and t has them.
            Assert.InRange(rougher, R.IsSingle ? 0 : 20, hits.Length);
        }

        /// <summary>Rays from near one sphere to the other one, every third of which passes its edge.</summary>
        private static Ray Start(ShapeCases cases, int k)
        {
            Point3D origin = new Point3D(3, -1, 2) + (0.4501 * cases.UnitVector()), to = new(2.2, -1, 2.5);
            return new Ray(origin, to + ((k % 3 == 0 ? 0.45 : 0.3) * cases.UnitVector()) - origin);
        }

        private static ShapeRun<R, F, I> Hits<R, F, I>(Shape[] spheres, Ray[] rays)
            where R : unmanaged, ILane<R, F, I>
            where F : unmanaged, ILane<F, F, I>
            where I : unmanaged, IIndexLane<I>
        {
            ShapeRun<R, F, I> run = new(spheres, Transform.Identity, Count);
            run.SetRays(rays);
            run.Nearest();
            return run;
        }
    }
}
