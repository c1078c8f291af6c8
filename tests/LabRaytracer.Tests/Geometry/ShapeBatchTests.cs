namespace LabRaytracer.Tests.Geometry;

/// <summary>Batches give the bits of single calls.</summary>
public sealed class ShapeBatchTests
{
    public static TheoryData<string> Kinds => [.. ShapeCases.Kinds];

    [Theory, MemberData(nameof(Kinds))]
    public void Nearest_DoubleLanesOfAnyWidth_SameBitsAsOneRay(string kind) => new DoubleTest(kind).RunAllDoubles();

    [Theory, MemberData(nameof(Kinds))]
    public void Nearest_FloatLanesOfAnyWidth_SameBitsAsOneLane(string kind)
    {
        FloatTest test = new(kind);
        test.RunAllFloats();
        Assert.Equal(4, test.Runs);
    }

    private static Ray[] Rays(string kind, out Shape[] shapes)
    {
        ShapeCases cases = new(11);
        shapes = [.. Enumerable.Range(0, 3).Select(i => cases.Create(kind, cases.Center(2), 0.5 + i))];
        return [.. Enumerable.Range(0, 501).Select(_ => cases.RayAt(Point3D.Origin, 2, Transform.Identity))];
    }

    private sealed class DoubleTest(string kind) : ILaneTest
    {
        public void Run<R, F, I>()
            where R : unmanaged, ILane<R, F, I>
            where F : unmanaged, ILane<F, F, I>
            where I : unmanaged, IIndexLane<I>
        {
            Ray[] rays = Rays(kind, out Shape[] shapes);
            using ShapeRun<R, F, I> run = new(shapes, Transform.Identity, rays.Length);
            run.SetRays(rays);
            run.Nearest();
            int[] hits = run.Surface();
            Assert.InRange(hits.Length, 25, rays.Length);
            for (int i = 0; i < hits.Length; i++)
            {
                Shape shape = shapes[run.ObjectOf(hits[i])];
                Assert.True(shape.Intersect(rays[hits[i]], double.PositiveInfinity, out Hit hit));
                Assert.Equal(hit.T, run.Distance(hits[i]));
                Assert.Equal(ShapeRun<R, F, I>.Numbers(shape.SurfaceAt(rays[hits[i]], hit)), run.SurfaceNumbers(i));
            }

            run.Block();
            for (int i = 0; i < rays.Length; i++)
            {
                double nearest = shapes.Min(shape => shape.Intersect(rays[i], double.PositiveInfinity, out Hit hit) ? hit.T : double.PositiveInfinity);
                Assert.Equal(nearest < double.PositiveInfinity, run.IsBlocked(i));
                Assert.Equal(nearest < double.PositiveInfinity, run.IsHit(i));
            }
        }
    }

    private sealed class FloatTest(string kind) : ILaneTest
    {
        private List<double[]>? _first;

        public int Runs { get; private set; }

        public void Run<R, F, I>()
            where R : unmanaged, ILane<R, F, I>
            where F : unmanaged, ILane<F, F, I>
            where I : unmanaged, IIndexLane<I>
        {
            Ray[] rays = Rays(kind, out Shape[] shapes);
            using ShapeRun<R, F, I> run = new(shapes, Transform.Rotation(new Vector3D(1, 2, 3), 40), rays.Length);
            run.SetRays(rays);
            run.Nearest();
            int[] hits = run.Surface();
            List<double[]> all = [.. hits.Select((ray, i) => (double[])[ray, run.ObjectOf(ray), run.Distance(ray), .. run.SurfaceNumbers(i)])];
            Assert.InRange(all.Count, 25, rays.Length);
            _first ??= all;
            Assert.Equal(_first, all);
            Runs++;
        }
    }
}
