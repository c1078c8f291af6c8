namespace LabRaytracer.Tests.Geometry;

/// <summary>A student's shape takes part with the same bits as a built-in one, where that one needs no more digits than doubles have.</summary>
public sealed class CustomShapeTests
{
    [Fact]
    public void Surface_StudentSphereWithSameFormulas_SameBitsAsBuiltIn() => new Comparison(Transform.Identity).RunAllDoubles();

    [Fact]
    public void Surface_TransformedStudentSphere_SameBitsAsBuiltIn() => new Comparison(
        Transform.Scaling(new Vector3D(2, 0.5, -1)).Then(Transform.Rotation(new Vector3D(1, 1, 0), 30)).Then(Transform.Translation(new Vector3D(3, -1, 2))))
        .RunAllDoubles();

    [Fact]
    public void Nearest_ShapeReturnsNaN_NeverAHit()
    {
        using ShapeRun<Double8, Float8, Int8> run = new([new NaNShape()], Transform.Identity, 8);
        run.SetRays([new Ray(Point3D.Origin, Vector3D.UnitX), new Ray(Point3D.Origin, Vector3D.UnitY)]);
        run.Nearest();
        run.Block();
        Assert.False(run.IsHit(0) || run.IsHit(1) || run.IsBlocked(0) || run.IsBlocked(1));
    }

    private sealed class Comparison(Transform transform) : ILaneTest
    {
        public void Run<R, F, I>()
            where R : unmanaged, ILane<R, F, I>
            where F : unmanaged, ILane<F, F, I>
            where I : unmanaged, IIndexLane<I>
        {
            ShapeCases cases = new(5);
            Ray[] rays = [.. Enumerable.Range(0, 333).Select(_ => cases.RayAt(new Point3D(1, 2, 3), 1.5, transform))];
            StudentSphere shape = new(new Point3D(1, 2, 3), 1.5);
            using ShapeRun<R, F, I> student = new([shape], transform, rays.Length);
            using ShapeRun<R, F, I> own = new([new Sphere(new Point3D(1, 2, 3), 1.5)], transform, rays.Length);
            student.SetRays(rays);
            own.SetRays(rays);
            student.Nearest();
            own.Nearest();
            int[] hits = own.Surface();
            Assert.InRange(hits.Length, 50, rays.Length);
            Assert.Equal(hits, student.Surface());
            int[] ordinary = [.. Enumerable.Range(0, hits.Length).Where(i => shape.IsOrdinary(transform.ObjectFromWorld(rays[hits[i]])))];
            Assert.InRange(ordinary.Length, 50, hits.Length);
            foreach (int i in ordinary)
            {
                Assert.Equal(own.Distance(hits[i]), student.Distance(hits[i]));
                Assert.Equal(own.SurfaceNumbers(i), student.SurfaceNumbers(i));
            }
        }
    }

    /// <summary>What a student would write, with the library's formulas for a sphere in plain doubles.</summary>
    private sealed class StudentSphere(Point3D center, double radius) : Shape
    {
        public override Bounds Bounds => Bounds.Everything;

        public override IMapping DefaultMapping => new SphericalMapping();

        public override bool Intersect(in Ray ray, double limit, out Hit hit)
        {
            (double k, double step, double half, double discriminant, _) = Solve(ray);
            double near = k + (step - half);
            double t = near > 0 ? near : k + (step + half);
            hit = new Hit(t);
            return discriminant >= 0 && t > 0 && t < limit;
        }

        public override SurfacePoint SurfaceAt(in Ray ray, in Hit hit)
        {
            (double k, double step, double half, _, Vector3D l) = Solve(ray);
            double along = step + (k + (step - half) > 0 && hit.T <= k + step ? -half : half);
            Vector3D p = new Ray(new Point3D(l.X, l.Y, l.Z), ray.Direction).PointAt(along).ToVector();
            Vector3D normal = p * (1 / Math.Sqrt(Vector3D.Dot(p, p)));
            Point3D point = new Ray(center, normal).PointAt(radius);
            double slack = (Math.Abs(center.X) + Math.Abs(center.Y) + Math.Abs(center.Z) + radius) * 3.552713678800501e-15;
            return new SurfacePoint(point, normal, normal, new SurfacePosition(new Point3D(normal.X, normal.Y, normal.Z), normal, default), slack);
        }

        /// <summary>False for rays that graze the sphere or start near their hit: the built-in sphere refines them.</summary>
        public bool IsOrdinary(in Ray ray)
        {
            (double k, double step, double half, _, _) = Solve(ray);
            double near = k + (step - half), t = near > 0 ? near : k + (step + half);
            return half * Math.Min(t < 3.01 * half ? t / 2 : t, 10 * half) * Vector3D.Dot(ray.Direction, ray.Direction) > 1.01 * radius * radius;
        }

        private (double K, double Step, double Half, double Discriminant, Vector3D L) Solve(in Ray ray)
        {
            Vector3D d = ray.Direction;
            Vector3D f = ray.Origin - center;
            double inverse = 1 / Vector3D.Dot(d, d);
            double k = -Vector3D.Dot(f, d) * inverse;
            Vector3D l = new(
                Math.FusedMultiplyAdd(k, d.X, f.X) + Lost(ray.Origin.X, center.X),
                Math.FusedMultiplyAdd(k, d.Y, f.Y) + Lost(ray.Origin.Y, center.Y),
                Math.FusedMultiplyAdd(k, d.Z, f.Z) + Lost(ray.Origin.Z, center.Z));
            double along = Vector3D.Dot(l, d);
            double step = -along * inverse;
            double discriminant = Math.FusedMultiplyAdd(radius, radius, -Math.FusedMultiplyAdd(step, along, Vector3D.Dot(l, l)));
            return (k, step, Math.Sqrt(Math.Max(discriminant * inverse, 0)), discriminant, l);
        }

        /// <summary>What rounding took from a - b.</summary>
        private static double Lost(double a, double b)
        {
            double difference = a - b;
            double back = difference - a;
            return (a - (difference - back)) - (b + back);
        }
    }

    private sealed class NaNShape : Shape
    {
        public override Bounds Bounds => Bounds.Everything;

        public override IMapping DefaultMapping => new SphericalMapping();

        public override bool Intersect(in Ray ray, double limit, out Hit hit)
        {
            hit = new Hit(double.NaN);
            return true;
        }

        public override SurfacePoint SurfaceAt(in Ray ray, in Hit hit) => default;
    }
}
