namespace LabRaytracer.Tests;

/// <summary>Every mapping gives the same bits one point at a time and at every width, in the same precision.</summary>
public sealed class WidthTests
{
    private static readonly SurfacePosition[] Points = MakePoints();

    public static TheoryData<IMapping> Mappings =>
        [new RectangularMapping(), new CylindricalMapping(), new SphericalMapping(), new DiskMapping(), new BoxMapping(), new MeshMapping(),
            new HemisphericalMapping(), new EqualAreaMapping(), new LightProbeMapping(), new LightProbeMapping { Facing = LightProbeFacing.NegativeZ }, new TorusMapping(), new TorusMapping(0.25),
            new ConeMapping(), new ProjectorMapping(new Point3D(0.2, 0.3, 2), new Point3D(0, 0.1, 0), fieldOfViewDegrees: 50, aspect: 1.5)];

    [Theory]
    [MemberData(nameof(Mappings))]
    public void Map_EveryDoubleWidth_SameBitsAsSingleCall(IMapping mapping)
    {
        TextureCoordinate[] single = [.. Points.Select(point => mapping.Map(point))];
        (double[] U, double[] V) expected = ([.. single.Select(c => c.U)], [.. single.Select(c => c.V)]);
        SameBits(expected, WideMapping.Map<Double1>(mapping, Points));
        SameBits(expected, WideMapping.Map<Double4>(mapping, Points));
        SameBits(expected, WideMapping.Map<Double8>(mapping, Points));
        SameBits(expected, WideMapping.Map<Double16>(mapping, Points));
    }

    [Theory]
    [MemberData(nameof(Mappings))]
    public void Map_EveryFloatWidth_SameBits(IMapping mapping)
    {
        (double[] U, double[] V) expected = WideMapping.Map<Float1>(mapping, Points);
        SameBits(expected, WideMapping.Map<Float4>(mapping, Points));
        SameBits(expected, WideMapping.Map<Float8>(mapping, Points));
        SameBits(expected, WideMapping.Map<Float16>(mapping, Points));
    }

    [Theory]
    [MemberData(nameof(Mappings))]
    public void Gradient_EveryDoubleWidth_SameBitsAsSingleCallAndFinite(IMapping mapping)
    {
        MappingGradient[] expected = [.. Points.Select(point => mapping.Gradient(point))];
        Assert.All(Points.Zip(expected), pair => Assert.True(!pair.First.LocalPoint.IsFinite || (pair.Second.U.IsFinite && pair.Second.V.IsFinite)));
        Assert.Equal(expected, WideMapping.Gradients<Double1>(mapping, Points));
        Assert.Equal(expected, WideMapping.Gradients<Double4>(mapping, Points));
        Assert.Equal(expected, WideMapping.Gradients<Double8>(mapping, Points));
        Assert.Equal(expected, WideMapping.Gradients<Double16>(mapping, Points));
    }

    [Theory]
    [MemberData(nameof(Mappings))]
    public void Gradient_EveryFloatWidth_SameBits(IMapping mapping)
    {
        MappingGradient[] expected = WideMapping.Gradients<Float1>(mapping, Points);
        Assert.Equal(expected, WideMapping.Gradients<Float4>(mapping, Points));
        Assert.Equal(expected, WideMapping.Gradients<Float8>(mapping, Points));
        Assert.Equal(expected, WideMapping.Gradients<Float16>(mapping, Points));
    }

    [Fact]
    public void Map_EveryPointAndPrecision_StaysInRange()
    {
        foreach (IMapping mapping in new IMapping[] { new SphericalMapping(), new CylindricalMapping(), new DiskMapping() })
        {
            (double[] U, double[] V) wide = WideMapping.Map<Double16>(mapping, Points);
            (double[] U, double[] V) narrow = WideMapping.Map<Float16>(mapping, Points);
            Assert.All(wide.U.Concat(narrow.U), u => Assert.True(u is >= 0 and < 1));
            if (mapping is SphericalMapping)
            {
                Assert.All(wide.V.Concat(narrow.V), v => Assert.True(v is >= 0 and <= 1));
            }
        }
    }

    private static void SameBits((double[] U, double[] V) expected, (double[] U, double[] V) actual)
    {
        for (int i = 0; i < expected.U.Length; i++)
        {
            UlpAssert.SameBits(expected.U[i], actual.U[i]);
            UlpAssert.SameBits(expected.V[i], actual.V[i]);
        }
    }

    /// <summary>20000 random points, then every triple of hard coordinates, mixed so that ordinary and extreme lanes share a group.</summary>
    private static SurfacePosition[] MakePoints()
    {
        var random = new Random(20090206);
        double[] hard =
        [
            0.0, -0.0, 1, -1, 0.5, 1e-320, -1e-320, 1e-300, -1e-300, 1e-45, 1e-38, -1e-20, 1e19, 1e38, 1e155, -1e300,
            double.MaxValue, double.PositiveInfinity, double.NegativeInfinity, double.NaN, Math.BitIncrement(1), 0.41421356237309503,

            // Beside the limits below and above which points are scaled.
            3.048087173287972e-12, 4796727, 1.3e-60, 2.5e120,
        ];
        var points = new List<SurfacePosition>();
        double Next() => (2 * random.NextDouble()) - 1;
        for (int i = 0; i < 20000; i++)
        {
            points.Add(new SurfacePosition(new Point3D(Next(), Next(), Next()), new Vector3D(Next(), Next(), Next()), new TextureCoordinate(Next(), Next())));
        }

        foreach (double x in hard)
        {
            foreach (double y in hard)
            {
                foreach (double z in hard)
                {
                    points.Insert(random.Next(points.Count), SurfacePosition.At(x, y, z));
                }
            }
        }

        return [.. points];
    }
}
