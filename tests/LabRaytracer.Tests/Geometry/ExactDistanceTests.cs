namespace LabRaytracer.Tests.Geometry;

/// <summary>Ray parameters that lie halfway between two doubles, touch, or start on the surface: exact arithmetic decides.</summary>
public sealed class ExactDistanceTests
{
    /// <summary>2^-53: half the distance from 1 to the next double.</summary>
    private const double Half = 1.1102230246251565e-16;

    [Theory]
    [InlineData(1, 1)]
    [InlineData(1 + (2 * Half), 1 + (4 * Half))]
    [InlineData(1 + (4 * Half), 1 + (4 * Half))]
    public void OfPlane_HalfwayBetweenTwoDoubles_TakesTheEvenOne(double height, double expected)
    {
        Ray ray = new(new Point3D(0, -Half, 0), Vector3D.UnitY);
        Assert.Equal(expected, ExactDistance.OfPlane(ray, new Point3D(0, height, 0), Vector3D.UnitY));
    }

    [Theory]
    [InlineData(1, 1)]
    [InlineData(1 + (2 * Half), 1 + (4 * Half))]
    public void OfSphereAndCylinder_HalfwayBetweenTwoDoubles_TakeTheEvenOne(double nearest, double expected)
    {
        Ray ray = new(new Point3D(0, 0, -Half), Vector3D.UnitZ);
        Point3D center = new(0, 0, 2);
        Assert.Equal(expected, ExactDistance.OfSphere(ray, center, 2 - nearest));
        Assert.Equal(expected, ExactDistance.OfCylinder(ray, center, 2 - nearest, 1));
    }

    [Fact]
    public void OfSphere_IrrationalDistance_IsTheNearestDouble()
    {
        // mpmath: 3 - 3 / sqrt(2) = 0.878679656440357426797466913685...
        Assert.Equal(0.8786796564403574, ExactDistance.OfSphere(new Ray(Point3D.Origin, new Vector3D(1, 1, 0)), new Point3D(3, 3, 0), 3));
    }

    [Fact]
    public void OfSphere_TouchingRay_HitsWhereItTouches()
    {
        Assert.Equal(2, ExactDistance.OfSphere(new Ray(new Point3D(1, 0, -2), Vector3D.UnitZ), Point3D.Origin, 1));
        Assert.Equal(double.NaN, ExactDistance.OfSphere(new Ray(new Point3D(1 + (2 * Half), 0, -2), Vector3D.UnitZ), Point3D.Origin, 1));
    }

    [Fact]
    public void OfSphere_RayThatStartsOnTheSurface_MeetsTheOtherSide()
    {
        Assert.Equal(2, ExactDistance.OfSphere(new Ray(new Point3D(0, 0, -1), Vector3D.UnitZ), Point3D.Origin, 1));
        Assert.Equal(double.NaN, ExactDistance.OfSphere(new Ray(new Point3D(0, 0, 1), Vector3D.UnitZ), Point3D.Origin, 1));
    }

    [Theory]
    [InlineData(2, 2, 2)]
    [InlineData(2, 1.9999999999999998, double.NaN)]
    [InlineData(-2, 2, 2)]
    public void OfCylinder_HitOnTheRim_CountsAsInside(double slope, double halfHeight, double expected)
    {
        // From the axis outwards: the mantle is met after 2 at the height of half the slope times 2.
        Ray ray = new(Point3D.Origin, new Vector3D(0.5, slope / 2, 0));
        Assert.Equal(expected, ExactDistance.OfCylinder(ray, Point3D.Origin, 1, halfHeight));
    }

    [Fact]
    public void OfCylinder_RayAlongTheAxis_Misses() =>
        Assert.Equal(double.NaN, ExactDistance.OfCylinder(new Ray(new Point3D(0, -3, 0), Vector3D.UnitY), Point3D.Origin, 1, 1));

    [Theory]
    [InlineData(5e-324)]
    [InlineData(1e-310)]
    [InlineData(1)]
    [InlineData(double.MaxValue)]
    public void Nearest_OfADouble_IsTheDouble(double value) => Assert.Equal(value, ExactNumber.Nearest(number => ((ExactNumber)value - number).Sign));
}
