namespace LabRaytracer.Tests.Geometry;

/// <summary>The quick look at spheres by rays through one point: it must see every ray that hits.</summary>
public sealed unsafe class ApexLookTests
{
    [Theory]
    [InlineData(1, 1)]
    [InlineData(1, 1e-4)]
    [InlineData(1e6, 1)]
    [InlineData(1e-6, 1e-6)]
    [InlineData(1e3, 5e2)]
    public void Run_RaysFromTheApexNearTheSilhouette_SeesEveryHit(double distance, double radius)
    {
        var random = new Random(11);
        int hits = 0;
        for (int i = 0; i < 3000; i++)
        {
            Point3D apex = Point3D.Origin + (Direction(random) * (distance * random.NextDouble()));
            var sphere = new Sphere(Point3D.Origin + (Direction(random) * distance), radius);
            Vector3D toCenter = sphere.Center - apex;
            Vector3D beside = Vector3D.Cross(toCenter, Direction(random)).Normalized();
            Vector3D direction = (toCenter + (beside * (radius * (1 + ((random.NextDouble() - 0.5) * Math.Pow(10, -random.Next(0, 15))))))).Normalized();
            if (sphere.Intersect(new Ray(apex, direction), double.PositiveInfinity, out _))
            {
                hits++;
                Assert.True(Sees(new RayBounds(apex, apex, direction, direction, 1, double.PositiveInfinity) { Apex = apex, Sense = 1 }, sphere, direction));
            }
        }

        Assert.True(hits > 500);
    }

    [Theory]
    [InlineData(3, 0.45)]
    [InlineData(10, 1e-3)]
    [InlineData(1e5, 4)]
    public void Run_RaysToTheApex_SeesEveryHitBeforeIt(double distance, double radius)
    {
        var random = new Random(12);
        int hits = 0;
        for (int i = 0; i < 3000; i++)
        {
            Point3D apex = Point3D.Origin + (Direction(random) * distance);
            var sphere = new Sphere(Point3D.Origin + (Direction(random) * (distance * random.NextDouble() / 2)), radius);
            Vector3D toCenter = sphere.Center - apex;
            Vector3D beside = Vector3D.Cross(toCenter, Direction(random)).Normalized() * (radius * 1.2 * random.NextDouble());
            Point3D origin = apex + ((toCenter + beside) * (1 + random.NextDouble()));
            Vector3D way = apex - origin, direction = way.Normalized();
            if (sphere.Intersect(new Ray(origin, direction), way.Length, out _))
            {
                hits++;
                Assert.True(Sees(new RayBounds(origin, origin, way, way, 0, 1) { Apex = apex, Sense = -1 }, sphere, direction));
            }
        }

        Assert.True(hits > 500);
    }

    [Fact]
    public void Run_RaysFarBesideOrBehind_SeesNone()
    {
        var sphere = new Sphere(new Point3D(0, 0, -5), 1);
        RayBounds bounds = new(Point3D.Origin, Point3D.Origin, -Vector3D.UnitZ, -Vector3D.UnitZ, 1, double.PositiveInfinity) { Sense = 1 };
        Assert.True(Sees(bounds, sphere, -Vector3D.UnitZ));
        Assert.False(Sees(bounds, sphere, Vector3D.UnitZ));
        Assert.False(Sees(bounds, sphere, new Vector3D(0.3, 0, -1).Normalized()));
    }

    private static Vector3D Direction(Random random) => new Vector3D(random.NextDouble() - 0.5, random.NextDouble() - 0.5, random.NextDouble() - 0.5).Normalized();

    private static bool Sees(in RayBounds bounds, Sphere sphere, Vector3D direction)
    {
        Float1 x = Float1.Of(direction.X), y = Float1.Of(direction.Y), z = Float1.Of(direction.Z);
        int seen;
        return new ApexLook(bounds, sphere.Center, sphere.Radius).Run(new VectorColumns<Float1>(&x, &y, &z), 0, 1, &seen) == 1;
    }
}
