namespace LabRaytracer.Tests.Geometry;

/// <summary>Secondary rays that start outside a hit's slack never meet their own surface again; those that go in find the far side.</summary>
public sealed class SelfIntersectionTests
{
    public static TheoryData<string> Kinds => [.. ShapeCases.Kinds];

    [Theory, MemberData(nameof(Kinds))]
    public void Nearest_DoubleRayLeavesSurface_NeverHitsItself(string kind) => new Sweep(kind).Run<Double16, Float16, Int16>();

    [Theory, MemberData(nameof(Kinds))]
    public void Nearest_FloatRayLeavesSurface_NeverHitsItself(string kind) => new Sweep(kind).Run<Float16, Float16, Int16>();

    private sealed class Sweep(string kind) : ILaneTest
    {
        private const int Shapes = 200, RaysEach = 150;

        public void Run<R, F, I>()
            where R : unmanaged, ILane<R, F, I>
            where F : unmanaged, ILane<F, F, I>
            where I : unmanaged, IIndexLane<I>
        {
            ShapeCases cases = new(77);
            int left = 0;
            string worst = "";
            int selfHits = 0;
            for (int i = 0; i < Shapes; i++)
            {
                // Sizes from 1e-6 to 1e6; centres up to 1e6 as far as the precision can still tell the size from the centre.
                double size = cases.Scale(-6, 6);
                double reach = Math.Min(1e6, size * cases.Scale(-1, R.IsSingle ? 2 : 9));
                Point3D center = cases.Center(i % 2 == 0 ? reach : 0);
                Transform transform = i % 4 < 2 ? Transform.Identity : cases.Transform(reach);
                Shape shape = cases.Create(kind, center, size);
                using ShapeRun<R, F, I> run = new([shape], transform, RaysEach);
                Ray[] rays = [.. Enumerable.Range(0, RaysEach).Select(_ => cases.RayAt(center, size, transform))];
                run.SetRays(rays);
                run.Nearest();
                int[] hits = run.Surface();
                double[][] surfaces = [.. hits.Select((_, element) => run.SurfaceNumbers(element))];
                run.SetRays([.. surfaces.Select(s => Leaving(s, cases, R.IsSingle))]);
                run.Nearest();
                left += surfaces.Length;
                for (int ray = 0; ray < surfaces.Length; ray++)
                {
                    Assert.True(surfaces[ray].All(double.IsFinite));
                    if (run.IsHit(ray) && (!IsHollow || run.Distance(ray) < 4 * surfaces[ray][17]))
                    {
                        selfHits++;
                        worst = Describe(i, size, center, surfaces[ray], run.Distance(ray));
                    }
                }

                run.SetRays([.. surfaces.Select(s => Inward(s, transform.WorldFromObject(center + (cases.UnitVector() * (0.2 * size)))))]);
                run.Nearest();
                for (int ray = 0; ray < surfaces.Length; ray++)
                {
                    Assert.True(!IsClosed || run.IsHit(ray), "lost inside: " + Describe(i, size, center, surfaces[ray], 0));
                }
            }

            Assert.InRange(left, Shapes * RaysEach / 20, Shapes * RaysEach);
            Assert.True(selfHits == 0, $"{selfHits} of {left}: {worst}");
        }

        /// <summary>A ray that leaves the inner side of a ring meets the other side, but not at once.</summary>
        private bool IsHollow => kind == "torus";

        private bool IsClosed => kind is "sphere" or "box";

        private static string Describe(int shape, double size, Point3D center, double[] s, double t) =>
            $"shape {shape} size {size:g3} centre {center}, point ({s[0]}, {s[1]}, {s[2]}), slack {s[17]:g3}, t {t:g3}";

        private Ray Leaving(double[] s, ShapeCases cases, bool isSingle)
        {
            // One in three almost along the surface, but not so much that rounding the direction turns it to the other side.
            Vector3D normal = new(s[3], s[4], s[5]);
            Vector3D random = cases.UnitVector();
            double up = Vector3D.Dot(random, normal);
            random = !IsHollow && cases.Number(0, 3) < 1 ? random - (normal * (up - cases.Scale(isSingle ? -5 : -13, -1))) : up < 0 ? -random : random;
            random = IsHollow ? random + (normal * 0.05) : random;
            return new Ray(new Point3D(s[0], s[1], s[2]) + (normal * s[17]), random.Normalized());
        }

        /// <summary>From just below the surface to a point well inside: near an edge any other ray may leave at once.</summary>
        private static Ray Inward(double[] s, Point3D inside)
        {
            Point3D start = new Point3D(s[0], s[1], s[2]) - (new Vector3D(s[3], s[4], s[5]) * s[17]);
            return new Ray(start, (inside - start).Normalized());
        }
    }
}
