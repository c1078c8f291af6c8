namespace LabRaytracer.Tests.Geometry;

/// <summary>Shapes behind an uneven scale and a rotation by 30 degrees, against explicit computation.</summary>
public sealed class TransformedShapeTests
{
    // Scale (2, 1, 0.5), then 30 degrees about +Z (x' = x cos - y sin, y' = x sin + y cos), then (1, 2, 3): an ellipsoid.
    private static readonly double s_cos = Math.Sqrt(3) / 2;
    private static readonly Transform s_transform = Transform.Scaling(new Vector3D(2, 1, 0.5))
        .Then(Transform.Rotation(Vector3D.UnitZ, 30))
        .Then(Transform.Translation(new Vector3D(1, 2, 3)));

    [Fact]
    public void Surface_EllipsoidFromManySides_MatchesImplicitEquation()
    {
        ShapeCases cases = new(3);
        Ray[] rays = [.. Enumerable.Range(0, 400).Select(_ => cases.RayAt(Point3D.Origin, 1, s_transform))];
        using ShapeRun<Double16, Float16, Int16> run = new([new Sphere()], s_transform, rays.Length);
        run.SetRays(rays);
        run.Nearest();
        int[] hits = run.Surface();
        Assert.InRange(hits.Length, 100, 400);
        for (int i = 0; i < hits.Length; i++)
        {
            double[] s = run.SurfaceNumbers(i);
            Vector3D p = new Vector3D(s[0], s[1], s[2]) - new Vector3D(1, 2, 3);
            Vector3D axes = new((p.X * s_cos) + (p.Y * 0.5), (p.Y * s_cos) - (p.X * 0.5), p.Z);

            // The point satisfies x^2 / 4 + y^2 + 4 z^2 = 1 along the axes; the normal is the gradient of that.
            Assert.Equal(1, (axes.X * axes.X / 4) + (axes.Y * axes.Y) + (4 * axes.Z * axes.Z), 1e-14);
            Vector3D gradient = new Vector3D(axes.X / 4, axes.Y, 4 * axes.Z).Normalized();
            Vector3D normal = new((gradient.X * s_cos) - (gradient.Y * 0.5), (gradient.X * 0.5) + (gradient.Y * s_cos), gradient.Z);
            Assert.Equal(0, (normal - new Vector3D(s[3], s[4], s[5])).Length, 1e-14);
            Assert.Equal(0, (new Vector3D(axes.X / 2, axes.Y, 2 * axes.Z) - new Vector3D(s[9], s[10], s[11])).Length, 1e-14);
            Assert.Equal(0, (rays[hits[i]].PointAt(run.Distance(hits[i])) - new Point3D(s[0], s[1], s[2])).Length, 1e-13);
        }
    }

    [Fact]
    public void Surface_MirroredPlane_NormalStaysOnItsSideOfTheSurface()
    {
        Transform mirror = Transform.Scaling(new Vector3D(1, -3, 1)).Then(Transform.Translation(new Vector3D(0, 5, 0)));
        using ShapeRun<Double4, Float4, Int4> run = new([new Quad()], mirror, 4);
        run.SetRays([new Ray(new Point3D(0.25, 0, 0.5), Vector3D.UnitY)]);
        run.Nearest();
        Assert.Equal(5, run.Distance(0));
        Assert.Equal([0], run.Surface());
        Assert.Equal([0.25, 5, 0.5, 0, -1, 0], run.SurfaceNumbers(0)[..6]);
    }

    [Fact]
    public void Nearest_TransformedCylinder_DistanceIsInWorldUnits()
    {
        // A cylinder of radius 3 along x: turned by 90 degrees about z and scaled by 3.
        Transform transform = Transform.Scaling(new Vector3D(3, 3, 3)).Then(Transform.Rotation(Vector3D.UnitZ, 90));
        using ShapeRun<Double8, Float8, Int8> run = new([new Cylinder()], transform, 8);
        run.SetRays([new Ray(new Point3D(1, 0, 10), -Vector3D.UnitZ), new Ray(new Point3D(3.5, 0, 10), -Vector3D.UnitZ)]);
        run.Nearest();
        Assert.Equal(7, run.Distance(0), 1e-14);
        Assert.False(run.IsHit(1));
    }
}
