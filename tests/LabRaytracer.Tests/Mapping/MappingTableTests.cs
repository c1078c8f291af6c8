namespace LabRaytracer.Tests;

/// <summary>The six rows of the table in each mapping's documentation, and the wrap it asks for.</summary>
public sealed class MappingTableTests
{
    [Theory]
    [InlineData(0, 0, 0, 0.5, 0.5)]
    [InlineData(-1, 0, -1, 0, 0)]
    [InlineData(1, 0, -1, 0, 1)]
    [InlineData(-1, 0, 1, 1, 0)]
    [InlineData(1, 0, 1, 1, 1)]
    [InlineData(0.5, 0, -0.5, 0.25, 0.75)]
    public void Rectangular_TableRow_Matches(double x, double y, double z, double u, double v) => Check(new RectangularMapping(), x, y, z, u, v);

    [Theory]
    [InlineData(0, 0, 1, 0, 0.5)]
    [InlineData(1, -1, 0, 0.25, 0)]
    [InlineData(0, 1, -1, 0.5, 1)]
    [InlineData(-1, 0.5, 0, 0.75, 0.75)]
    [InlineData(1, 0, 1, 0.125, 0.5)]
    [InlineData(0, 0, 0, 0, 0.5)]
    public void Cylindrical_TableRow_Matches(double x, double y, double z, double u, double v) => Check(new CylindricalMapping(), x, y, z, u, v);

    [Theory]
    [InlineData(0, 0, 1, 0, 0.5)]
    [InlineData(1, 0, 0, 0.25, 0.5)]
    [InlineData(0, 0, -1, 0.5, 0.5)]
    [InlineData(-1, 0, 0, 0.75, 0.5)]
    [InlineData(0, 1, 0, 0, 1)]
    [InlineData(0, -1, 0, 0, 0)]
    public void Spherical_TableRow_Matches(double x, double y, double z, double u, double v) => Check(new SphericalMapping(), x, y, z, u, v);

    [Theory]
    [InlineData(0, 0, 0, 0, 0)]
    [InlineData(0, 0, 1, 0, 1)]
    [InlineData(1, 0, 0, 0.25, 1)]
    [InlineData(0, 0, -0.5, 0.5, 0.5)]
    [InlineData(-0.25, 0, 0, 0.75, 0.25)]
    [InlineData(0.375, 0, 0.5, 0.10241638234956672, 0.625)]
    public void Disk_TableRow_Matches(double x, double y, double z, double u, double v) => Check(new DiskMapping(), x, y, z, u, v);

    [Theory]
    [InlineData(1, 0, 0, 1, 0.5, -0.5, 0.75, 0.75)]
    [InlineData(-1, 0, 0, -1, 0.5, -0.5, 0.25, 0.75)]
    [InlineData(0, 1, 0, 0.5, 1, -0.5, 0.75, 0.75)]
    [InlineData(0, -1, 0, 0.5, -1, -0.5, 0.75, 0.25)]
    [InlineData(0, 0, 1, 0.5, -0.5, 1, 0.75, 0.25)]
    [InlineData(0, 0, -1, 0.5, -0.5, -1, 0.25, 0.25)]
    public void Box_TableRow_Matches(double nx, double ny, double nz, double x, double y, double z, double u, double v) =>
        Assert.Equal(new TextureCoordinate(u, v), new BoxMapping().Map(new SurfacePosition(new Point3D(x, y, z), new Vector3D(nx, ny, nz), default)));

    [Theory]
    [InlineData(0, 0)]
    [InlineData(1, 0)]
    [InlineData(0, 1)]
    [InlineData(0.25, 0.75)]
    [InlineData(-0.5, 3)]
    [InlineData(1, 1)]
    public void Mesh_TableRow_Matches(double u, double v) =>
        Assert.Equal(new TextureCoordinate(u, v), new MeshMapping().Map(new SurfacePosition(new Point3D(1, 2, 3), Vector3D.UnitX, new TextureCoordinate(u, v))));

    [Theory]
    [InlineData(0, 1, 0, 0, 1)]
    [InlineData(0, 0, 1, 0, 0)]
    [InlineData(1, 1, 0, 0.25, 0.5)]
    [InlineData(0, 2, -2, 0.5, 0.5)]
    [InlineData(-1, 0, 0, 0.75, 0)]
    [InlineData(0, -1, 0, 0, 0)]
    public void Hemispherical_TableRow_Matches(double x, double y, double z, double u, double v) => Check(new HemisphericalMapping(), x, y, z, u, v);

    [Theory]
    [InlineData(0, 0, 1, 0, 0.5)]
    [InlineData(1, 0, 0, 0.25, 0.5)]
    [InlineData(0, 1, 0, 0, 1)]
    [InlineData(0, -1, 0, 0, 0)]
    [InlineData(-4, 3, 0, 0.75, 0.8)]
    [InlineData(0, -3, -4, 0.5, 0.2)]
    public void EqualArea_TableRow_Matches(double x, double y, double z, double u, double v) => Check(new EqualAreaMapping(), x, y, z, u, v);

    [Theory]
    [InlineData(0, 0, 1, 0.5, 0.5)]
    [InlineData(1, 0, 0, 0.75, 0.5)]
    [InlineData(0, -1, 0, 0.5, 0.25)]
    [InlineData(-1, 0, 1, 0.375, 0.5)]
    [InlineData(0, 1, -1, 0.5, 0.875)]
    [InlineData(0, 0, -1, 1, 0.5)]
    public void LightProbe_TableRow_Matches(double x, double y, double z, double u, double v) => Check(new LightProbeMapping(), x, y, z, u, v);

    [Theory]
    [InlineData(0, 0, -1, 0.5, 0.5)]
    [InlineData(1, 0, 0, 0.75, 0.5)]
    [InlineData(0, -1, 0, 0.5, 0.25)]
    [InlineData(-1, 0, -1, 0.375, 0.5)]
    [InlineData(0, 1, 1, 0.5, 0.875)]
    [InlineData(0, 0, 0, 0.5, 0.5)]
    public void LightProbeFacingNegativeZ_TableRow_Matches(double x, double y, double z, double u, double v) => Check(new LightProbeMapping { Facing = LightProbeFacing.NegativeZ }, x, y, z, u, v);

    [Theory]
    [InlineData(0, 0, 1.5, 0, 0)]
    [InlineData(1, 0.5, 0, 0.25, 0.25)]
    [InlineData(0, 0, -0.5, 0.5, 0.5)]
    [InlineData(-1, -0.25, 0, 0.75, 0.75)]
    [InlineData(0, 0.25, 1.25, 0, 0.125)]
    [InlineData(0, 0, 0, 0, 0.5)]
    public void Torus_TableRow_Matches(double x, double y, double z, double u, double v) => Check(new TorusMapping(), x, y, z, u, v);

    [Theory]
    [InlineData(0, -1, 1, 0, 0)]
    [InlineData(0.5, 0, 0, 0.25, 0.5)]
    [InlineData(0, 0, -0.5, 0.5, 0.5)]
    [InlineData(0, 1, 0, 0, 1)]
    [InlineData(-0.25, 0.5, 0, 0.75, 0.75)]
    [InlineData(0, 0, 0.5, 0, 0.5)]
    public void ConeSide_TableRow_Matches(double x, double y, double z, double u, double v) => Check(new ConeMapping(), x, y, z, u, v);

    [Theory]
    [InlineData(0, 0, 0, 0.5, 0.5)]
    [InlineData(1, 1, 1, 1, 1)]
    [InlineData(-1, -1, 1, 0, 0)]
    [InlineData(1, 0, 0, 0.75, 0.5)]
    [InlineData(0, 4, 0, 0.5, 1.5)]
    [InlineData(0, 0, 3, -1, -1)]
    public void Projector_TableRow_Matches(double x, double y, double z, double u, double v) => Check(new ProjectorMapping(new Point3D(0, 0, 2), Point3D.Origin, fieldOfViewDegrees: 90), x, y, z, u, v);

    [Fact]
    public void Cone_BaseRow_Matches() => Assert.Equal(
        new TextureCoordinate(0.75, 0.25), new ConeMapping().Map(new SurfacePosition(new Point3D(0.5, -1, -0.5), new Vector3D(0, -1, 0), default)));

    [Fact]
    public void DefaultWrap_EachMapping_ClampsWhereThePictureEnds()
    {
        IMapping[] clamped = [new SphericalMapping(), new CylindricalMapping(), new DiskMapping()];
        IMapping[] repeated = [new RectangularMapping(), new BoxMapping(), new MeshMapping()];
        Assert.All(clamped, mapping => Assert.Equal((TextureWrap.Repeat, mapping is SphericalMapping ? TextureWrap.Pole : TextureWrap.Clamp), (mapping.DefaultWrapU, mapping.DefaultWrapV)));
        Assert.All(repeated, mapping => Assert.Equal((TextureWrap.Repeat, TextureWrap.Repeat), (mapping.DefaultWrapU, mapping.DefaultWrapV)));
    }

    [Fact]
    public void MapPoint_EachMapping_EqualsMapPosition()
    {
        var point = new Point3D(0.3, -0.4, 0.5);
        SurfacePosition position = SurfacePosition.At(0.3, -0.4, 0.5);
        Assert.Equal(new RectangularMapping().Map(position), new RectangularMapping().Map(point));
        Assert.Equal(new CylindricalMapping().Map(position), new CylindricalMapping().Map(point));
        Assert.Equal(new SphericalMapping().Map(position), new SphericalMapping().Map(point));
        Assert.Equal(new DiskMapping().Map(position), new DiskMapping().Map(point));
    }

    private static void Check(IMapping mapping, double x, double y, double z, double u, double v)
    {
        TextureCoordinate found = mapping.Map(SurfacePosition.At(x, y, z));
        Assert.Equal(u, found.U);
        Assert.Equal(v, found.V);
    }
}
