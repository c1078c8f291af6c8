namespace LabRaytracer.Tests.Numerics;

/// <summary>What bounds of many rays say of a shape, against the rays themselves.</summary>
public sealed class RayBoundsTests
{
    private const int Cases = 4000, Rays = 24;

    [Fact]
    public void MayMeet_RaysToALamp_NeverMissesWhatAnyRayHits()
    {
        Random random = new(5);
        int met = 0, left = 0, metPlanes = 0, leftPlanes = 0;
        for (int number = 0; number < Cases; number++)
        {
            Point3D least = Place(random, 2), lamp = Place(random, 4);
            Point3D largest = least + new Vector3D(random.NextDouble(), random.NextDouble() * 0.25, random.NextDouble());
            RayBounds bounds = ShadowBounds.Of(lamp, least, largest);
            Sphere sphere = new(Place(random, 3), 0.25 + random.NextDouble());
            InfinitePlane plane = new(Place(random, 3), Place(random, 1) - Point3D.Origin);
            bool meetsSphere = false, meetsPlane = false;
            for (int ray = 0; ray < Rays; ray++)
            {
                Ray aimed = Aim(random, least, largest, lamp, out double limit);
                meetsSphere |= sphere.Intersect(aimed, limit, out _);
                meetsPlane |= plane.Intersect(aimed, limit, out _);
            }

            bool maySphere = bounds.MayMeetSphere(sphere.Center, sphere.Radius), mayPlane = bounds.MayMeetPlane(plane.Point, plane.Normal);
            Assert.True(maySphere || !meetsSphere, $"Case {number}: a ray meets the sphere.");
            Assert.True(mayPlane || !meetsPlane, $"Case {number}: a ray meets the plane.");
            (met, left) = (met + (meetsSphere ? 1 : 0), left + (maySphere ? 0 : 1));
            (metPlanes, leftPlanes) = (metPlanes + (meetsPlane ? 1 : 0), leftPlanes + (mayPlane ? 0 : 1));
        }

        // Both answers are there, and the bounds leave most of what no ray meets.
        Assert.True(met > Cases / 20 && metPlanes > Cases / 10, $"{met} spheres and {metPlanes} planes met.");
        Assert.True(left > (Cases - met) / 2 && leftPlanes > (Cases - metPlanes) / 2, $"{left} of {Cases - met} spheres, {leftPlanes} of {Cases - metPlanes} planes left.");
    }

    [Fact]
    public void MayMeetPlane_CameraRays_OnlyThoseThatTurnToIt()
    {
        Point3D eye = new(1, 2, 3);
        RayBounds Looks(double leastY, double largestY) =>
            new(eye, eye, new Vector3D(-0.5, leastY, -1), new Vector3D(0.5, largestY, -1), 1, double.PositiveInfinity) { Apex = eye, Sense = 1 };
        Assert.False(Looks(0.125, 0.5).MayMeetPlane(Point3D.Origin, Vector3D.UnitY));
        Assert.True(Looks(-0.125, 0.5).MayMeetPlane(Point3D.Origin, Vector3D.UnitY));
        Assert.True(Looks(0, 0.5).MayMeetPlane(Point3D.Origin, Vector3D.UnitY));
        Assert.True(Looks(0.125, 0.5).MayMeetPlane(new Point3D(0, 4, 0), Vector3D.UnitY));
        Assert.False(Looks(-0.5, -0.125).MayMeetPlane(new Point3D(0, 4, 0), Vector3D.UnitY));
    }

    [Fact]
    public void MayMeet_NotFinite_MayBe()
    {
        RayBounds bounds = ShadowBounds.Of(new Point3D(0, 5, 0), new Point3D(double.NegativeInfinity, 1, 0), new Point3D(double.PositiveInfinity, 1, 0));
        Assert.True(bounds.MayMeetSphere(new Point3D(1e9, -5, 0), 1));
        Assert.True(bounds.MayMeetPlane(new Point3D(0, -1, 0), new Vector3D(1, 0, 0)));
        Assert.True(ShadowBounds.Of(new Point3D(0, 5, 0), Point3D.Origin, Point3D.Origin).MayMeetSphere(new Point3D(9, 9, 9), double.PositiveInfinity));
    }

    private static Point3D Place(Random random, double size) => new(
        size * ((2 * random.NextDouble()) - 1), size * ((2 * random.NextDouble()) - 1), size * ((2 * random.NextDouble()) - 1));

    private static Ray Aim(Random random, Point3D least, Point3D largest, Point3D lamp, out double limit)
    {
        Vector3D size = largest - least;
        Point3D origin = least + new Vector3D(size.X * random.NextDouble(), size.Y * random.NextDouble(), size.Z * random.NextDouble());
        limit = (lamp - origin).Length;
        return new Ray(origin, (lamp - origin) / limit);
    }
}
