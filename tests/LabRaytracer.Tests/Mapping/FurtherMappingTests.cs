namespace LabRaytracer.Tests;

/// <summary>Mappings beyond those of the lab sheet: ranges, edges, gradients, projectors.</summary>
public sealed class FurtherMappingTests
{
    private static readonly ProjectorMapping s_projector = new(new Point3D(0.2, 0.3, 3), new Point3D(0, 0.1, 0), fieldOfViewDegrees: 50, aspect: 1.5);

    public static TheoryData<IMapping> Closed => [new HemisphericalMapping(), new EqualAreaMapping(), new LightProbeMapping(), new TorusMapping(), new ConeMapping()];

    public static TheoryData<IMapping> All => [new HemisphericalMapping(), new EqualAreaMapping(), new LightProbeMapping(), new TorusMapping(), new ConeMapping(), new LightProbeMapping { Facing = LightProbeFacing.NegativeZ }, new TorusMapping(0.25), s_projector];

    [Theory, MemberData(nameof(Closed))]
    public void Map_PolesAxesAndExtremes_StaysInRange(IMapping mapping)
    {
        bool mayReachOne = mapping is LightProbeMapping;
        double[] hard = [0, -0.0, 1, -1, 1e-300, -1e-320, 1e-17, -1e-17, 1e155, -1e300, double.MaxValue, Math.BitDecrement(1), 0.5, -1.5];
        foreach (double x in hard)
        {
            foreach (double y in mapping is ConeMapping ? hard.Where(y => Math.Abs(y) <= 1) : hard)
            {
                foreach (double z in hard)
                {
                    TextureCoordinate at = mapping.Map(SurfacePosition.At(x, y, z));
                    Assert.True(at.U >= 0 && (mayReachOne ? at.U <= 1 : at.U < 1), $"u = {at.U} at ({x}, {y}, {z})");
                    Assert.InRange(at.V, 0, 1);
                }
            }
        }
    }

    /// <summary>Off the axes, where differences are good to 1e-8 of the gradient's length.</summary>
    [Theory, MemberData(nameof(All))]
    public void Gradient_OrdinaryPoints_AgreesWithDifferences(IMapping mapping)
    {
        var random = new Random(4);
        for (int i = 0; i < 300; i++)
        {
            Point3D p = new(Number(random), Number(random), Number(random));
            if (Math.Min(Math.Abs(p.Y), Math.Sqrt((p.X * p.X) + (p.Z * p.Z))) < 0.05 || Math.Sqrt((p.X * p.X) + (p.Y * p.Y)) < 0.05)
            {
                continue;
            }

            SurfacePosition position = new(p, new Vector3D(0.6, 0.8, 0), default);
            MappingGradient closed = mapping.Gradient(position), differences = MappingDifferences.Gradient(mapping, position);
            double size = closed.U.Length + closed.V.Length;
            Assert.True((closed.U - differences.U).Length <= 1e-7 * size, $"u at {p}: {closed.U}, {differences.U}");
            Assert.True((closed.V - differences.V).Length <= 1e-7 * size, $"v at {p}: {closed.V}, {differences.V}");
        }
    }

    [Fact]
    public void ConeGradient_OnTheBase_IsHalfAlongXAndZ()
    {
        SurfacePosition position = new(new Point3D(0.5, -1, 0.2), new Vector3D(0, -1, 0), default);
        Assert.Equal(new MappingGradient(new Vector3D(0.5, 0, 0), new Vector3D(0, 0, 0.5)), new ConeMapping().Gradient(position));
    }

    /// <summary>Seen along an axis, the light probe is not torn: around the middle its gradient is 1 / 2 pi in every direction.</summary>
    [Theory]
    [InlineData(0, 0)]
    [InlineData(1e-9, 0)]
    [InlineData(0, -1e-4)]
    public void LightProbe_Middle_HasAGradientOfOneTurn(double x, double y)
    {
        MappingGradient gradient = new LightProbeMapping().Gradient(SurfacePosition.At(x, y, 1));
        Assert.Equal(0.15915494309189535, gradient.U.X, 1e-8);
        Assert.Equal(0.15915494309189535, gradient.V.Y, 1e-8);
        Assert.Equal(0, gradient.U.Y, 1e-8);
    }

    /// <summary>Equal parts of the sphere: the area of (u, v) cells is the same everywhere (Archimedes).</summary>
    [Theory]
    [InlineData(0.3, 0.2, 0.4)]
    [InlineData(-0.1, 0.9, 0.2)]
    [InlineData(0.5, -0.7, -0.6)]
    public void EqualArea_AnyPoint_HasTheSameArea(double x, double y, double z)
    {
        Vector3D n = new Vector3D(x, y, z).Normalized();
        MappingGradient gradient = new EqualAreaMapping().Gradient(SurfacePosition.At(n.X, n.Y, n.Z));
        Assert.Equal(1 / (4 * Math.PI), Vector3D.Dot(Vector3D.Cross(gradient.U, gradient.V), n), 1e-12);
    }

    [Fact]
    public void Projector_PointsBehind_AreOutsideOfThePicture()
    {
        Assert.Equal(new TextureCoordinate(-1, -1), s_projector.Map(SurfacePosition.At(0.2, 0.3, 3)));
        Assert.Equal(new TextureCoordinate(-1, -1), s_projector.Map(SurfacePosition.At(0.4, 0.7, 6)));
        Assert.Equal(default, s_projector.Gradient(SurfacePosition.At(0, 0, 6)));
        Assert.Equal((TextureWrap.Border, TextureWrap.Border), (s_projector.DefaultWrapU, s_projector.DefaultWrapV));
        TextureCoordinate aim = s_projector.Map(SurfacePosition.At(0, 0.1, 0));
        Assert.Equal(0.5, aim.U, 1e-15);
        Assert.Equal(0.5, aim.V, 1e-15);
    }

    [Fact]
    public void Projector_InTheWorld_ReadsTheWorldPoint()
    {
        ProjectorMapping world = new(new Point3D(0, 0, 2), Point3D.Origin, fieldOfViewDegrees: 90, frame: TextureFrame.World);
        Assert.Equal(new TextureCoordinate(0.75, 0.5), world.Map(SurfacePosition.At(7, 8, 9) with { WorldPoint = new Point3D(1, 0, 0) }));

        // u = 1/2 + x / (2 (2 - z)), v = 1/2 + y / (2 (2 - z)): at (1, 0, 0) the gradients are (1/4, 0, 1/8) and (0, 1/4, 0).
        MappingGradient gradient = world.Gradient(SurfacePosition.At(7, 8, 9) with { WorldPoint = new Point3D(1, 0, 0) });
        Assert.InRange((gradient.U - new Vector3D(0.25, 0, 0.125)).Length, 0, 1e-15);
        Assert.InRange((gradient.V - new Vector3D(0, 0.25, 0)).Length, 0, 1e-15);
    }

    [Fact]
    public void Projector_BadArguments_AreRefused()
    {
        Assert.Throws<ArgumentException>(() => new ProjectorMapping(Point3D.Origin, Point3D.Origin));
        Assert.Throws<ArgumentException>(() => new ProjectorMapping(Point3D.Origin, new Point3D(0, 1, 0)));
        Assert.Throws<ArgumentOutOfRangeException>(() => new ProjectorMapping(Point3D.Origin, new Point3D(0, 0, 1), fieldOfViewDegrees: 180));
        Assert.Throws<ArgumentOutOfRangeException>(() => new ProjectorMapping(Point3D.Origin, new Point3D(0, 0, 1), aspect: 0));
        Assert.Throws<ArgumentOutOfRangeException>(() => new TorusMapping(0));
    }

    private static double Number(Random random) => (2 * random.NextDouble()) - 1;
}
