namespace LabRaytracer.Tests;

/// <summary>The sheet's errors, each shown on its own code or formula, and what this library does instead.</summary>
public sealed class ErrataTests
{
    [Fact]
    public void E1_PrintedRectangularV_IsOutsideThePicture_OursInside()
    {
        var random = new Random(1);
        int outside = 0;
        for (int i = 0; i < 1000; i++)
        {
            double x = (2 * random.NextDouble()) - 1;
            outside += (x - 1) / 2 < 0 ? 1 : 0;
            Assert.InRange(new RectangularMapping().Map(new Point3D(x, 0, 0)).V, 0, 1);
        }

        Assert.Equal(1000, outside);
    }

    [Theory]
    [InlineData(1, 1, 0.125)]
    [InlineData(-1, -1, 0.625)]
    [InlineData(1, 0, 0.25)]
    [InlineData(-1, 0, 0.75)]
    public void E2_OppositeQuadrants_AreKeptApart(double x, double z, double u)
    {
        Assert.Equal(Math.Atan(1), Math.Atan(-1.0 / -1.0));
        Assert.Equal(u, new CylindricalMapping().Map(new Point3D(x, 0, z)).U);
    }

    [Fact]
    public void E3_JustBeforeTheSeam_ProgramTwoGivesOne_OursStaysBelow()
    {
        var point = new Point3D(-1e-8, 0, 1);
        TexelCoordinates.GetTexelCoordinates(point, 512, 256, out _, out int column);
        Assert.Equal(511, column);
        Assert.InRange(new SphericalMapping().Map(point).U, 0.999, 1 - 1e-10);
        Assert.Equal(Math.BitDecrement(1), new SphericalMapping().Map(new Point3D(-1e-300, 0, 1)).U);
    }

    [Fact]
    public void E4_ProgramTwoColumn_DiffersFromTexelCentreOnHalfOfAllU()
    {
        const int Width = 512;
        int different = 0;
        for (int i = 0; i < 10000; i++)
        {
            double u = (i + 0.5) / 10000;
            different += (int)((Width - 1) * u) != (int)Math.Floor(Width * u) ? 1 : 0;
        }

        Assert.InRange(different, 4900, 5100);
    }

    [Fact]
    public void E6_AHairAboveOne_ProgramTwoReadsTheOppositePole_OursThePole()
    {
        var point = new Point3D(0, Math.BitIncrement(1), 0);
        TexelCoordinates.GetTexelCoordinates(point, 512, 256, out int row, out _);
        Assert.Equal(0, row);
        Assert.Equal(new TextureCoordinate(0, 1), new SphericalMapping().Map(point));
    }

    [Theory]
    [InlineData(1e-200)]
    [InlineData(0.3)]
    [InlineData(1.5)]
    [InlineData(1e200)]
    public void E7_RadiusOtherThanOne_GivesTheSameCoordinates(double radius)
    {
        var direction = new Vector3D(0.3, 0.8, -0.2);
        TextureCoordinate unit = new SphericalMapping().Map(Point3D.Origin + direction);
        TextureCoordinate scaled = new SphericalMapping().Map(Point3D.Origin + (direction * radius));
        Assert.Equal(unit.U, scaled.U, 15);
        Assert.Equal(unit.V, scaled.V, 15);
    }

    [Theory]
    [InlineData(1, 1)]
    [InlineData(-1, 0)]
    [InlineData(1e-310, 1)]
    public void E8_Axis_HasColumnZero(double y, double v)
    {
        Assert.Equal(new TextureCoordinate(0, v), new SphericalMapping().Map(new Point3D(0, y, 0)));
        Assert.Equal(new TextureCoordinate(0, v), new SphericalMapping().Map(new Point3D(-0.0, y, -0.0)));
    }

    [Fact]
    public void E10_Seam_IsTheHalfMeridianInFrontOfTheCamera()
    {
        for (int degrees = -80; degrees <= 80; degrees += 10)
        {
            (double sin, double cos) = Elementary.SinCosDegrees(degrees);
            Assert.Equal(0, new SphericalMapping().Map(new Point3D(0, sin, cos)).U);
            Assert.InRange(new SphericalMapping().Map(new Point3D(1e-9, sin, cos)).U, 1e-12, 1e-8);
            Assert.InRange(new SphericalMapping().Map(new Point3D(-1e-9, sin, cos)).U, 1 - 1e-8, 1 - 1e-12);
            Assert.Equal(0.5, new SphericalMapping().Map(new Point3D(0, sin, -cos)).U);
        }
    }

    [Theory]
    [InlineData(0.5)]
    [InlineData(2)]
    [InlineData(4)]
    public void E11_UThenV_TurnAroundTheOutwardNormal(double phi)
    {
        // A step in u times a step in v points outward in a right-handed frame: the picture is not mirrored from outside.
        (double sin, double cos) = Math.SinCos(phi);
        var sphere = new Point3D(0.8 * sin, 0.6, 0.8 * cos);
        Assert.True(Orientation(new SphericalMapping(), sphere, sphere.ToVector()) > 0);
        Assert.True(Orientation(new CylindricalMapping(), new Point3D(sin, 0.2, cos), new Vector3D(sin, 0, cos)) > 0);
        Assert.True(Orientation(new RectangularMapping(), new Point3D(0.1, 0, 0.2), Vector3D.UnitY) > 0);
        foreach (Vector3D normal in new[] { Vector3D.UnitX, -Vector3D.UnitX, Vector3D.UnitY, -Vector3D.UnitY, Vector3D.UnitZ, -Vector3D.UnitZ })
        {
            Assert.True(Orientation(new BoxMapping(), Point3D.Origin + normal, normal) > 0);
        }
    }

    /// <summary>Sign of the determinant of (u, v) along two tangents whose cross product is the outward normal.</summary>
    private static double Orientation(IMapping mapping, Point3D point, Vector3D normal)
    {
        Vector3D n = normal.Normalized();
        Vector3D first = Vector3D.Cross(Math.Abs(n.Y) > 0.9 ? Vector3D.UnitX : Vector3D.UnitY, n).Normalized();
        Vector3D second = Vector3D.Cross(n, first);
        TextureCoordinate At(Vector3D step) => mapping.Map(new SurfacePosition(point + (step * 1e-6), n, default));
        TextureCoordinate o = At(Vector3D.Zero), a = At(first), b = At(second);
        return ((a.U - o.U) * (b.V - o.V)) - ((a.V - o.V) * (b.U - o.U));
    }
}
