namespace LabRaytracer.Tests;

/// <summary>How fast texture coordinates change with the local point.</summary>
public sealed class GradientTests
{
    /// <summary>Units of 2^-53 of the gradient's length.</summary>
    private const double Bound = 8;

    private static readonly Dictionary<string, IMapping> s_mappings = new()
    {
        ["rectangular"] = new RectangularMapping(),
        ["cylindrical"] = new CylindricalMapping(),
        ["disk"] = new DiskMapping(),
        ["spherical"] = new SphericalMapping(),
    };

    [Fact]
    public void Gradient_OracleRows_WithinBound()
    {
        foreach (OracleRow row in OracleRow.Read("gradients", 3, single: false))
        {
            MappingGradient gradient = s_mappings[row.Name].Gradient(SurfacePosition.At(row.Inputs[0], row.Inputs[1], row.Inputs[2]));
            Within(row, Vector(row, 0), gradient.U, Bound * Math.Pow(2, -53));
            Within(row, Vector(row, 3), gradient.V, Bound * Math.Pow(2, -53));
        }
    }

    [Fact]
    public void Gradient_OracleRowsByDifferences_WithinStatedError()
    {
        foreach (OracleRow row in OracleRow.Read("gradients", 3, single: false).Where(row => Math.Abs(row.Inputs[0]) + Math.Abs(row.Inputs[2]) > 0.1))
        {
            IMapping mapping = new ByDifferences(s_mappings[row.Name]);
            MappingGradient gradient = mapping.Gradient(SurfacePosition.At(row.Inputs[0], row.Inputs[1], row.Inputs[2]));
            Within(row, Vector(row, 0), gradient.U, 2e-8);
            Within(row, Vector(row, 3), gradient.V, 2e-8);
        }
    }

    [Theory]
    [InlineData(1, 0, 0, 0, 0, -0.5, 0, 0.5, 0)]
    [InlineData(-1, 0, 0, 0, 0, 0.5, 0, 0.5, 0)]
    [InlineData(0, 1, 0, 0.5, 0, 0, 0, 0, -0.5)]
    [InlineData(0, -1, 0, 0.5, 0, 0, 0, 0, 0.5)]
    [InlineData(0, 0, 1, 0.5, 0, 0, 0, 0.5, 0)]
    [InlineData(0, 0, -1, -0.5, 0, 0, 0, 0.5, 0)]
    public void BoxGradient_EveryFace_IsHalfAlongItsAxes(double nx, double ny, double nz, double ux, double uy, double uz, double vx, double vy, double vz)
    {
        SurfacePosition position = new(new Point3D(nx, ny, nz), new Vector3D(nx, ny, nz), default);
        MappingGradient expected = new(new Vector3D(ux, uy, uz), new Vector3D(vx, vy, vz));
        Assert.Equal(expected, new BoxMapping().Gradient(position));
        Assert.Equal(expected, ((IMapping)new ByDifferences(new BoxMapping())).Gradient(position));
    }

    [Fact]
    public void MeshGradient_IsTheShapesOwn()
    {
        MappingGradient own = new(new Vector3D(1, 2, 3), new Vector3D(4, 5, 6));
        SurfacePosition position = new(new Point3D(1, 1, 1), Vector3D.UnitY, new TextureCoordinate(0.25, 0.75), own);
        Assert.Equal(own, new MeshMapping().Gradient(position));
        MappingGradient found = ((IMapping)new ByDifferences(new MeshMapping())).Gradient(position);
        Assert.InRange((found.U - own.U).Length + (found.V - own.V).Length, 0, 1e-9);
    }

    [Fact]
    public void SphericalGradient_AcrossTheSeam_IsContinuous()
    {
        IMapping mapping = new SphericalMapping();
        MappingGradient left = mapping.Gradient(SurfacePosition.At(-1e-12, 0, 1)), right = mapping.Gradient(SurfacePosition.At(1e-12, 0, 1));
        Assert.InRange((left.U - right.U).Length + (left.V - right.V).Length, 0, 1e-12);
    }

    [Theory]
    [InlineData(0, 1, 0)]
    [InlineData(0, -1, 0)]
    [InlineData(1e-9, 1, 0)]
    [InlineData(0, 1, -1e-300)]
    public void SphericalGradient_AtPoles_KeepsItsBound(double x, double y, double z)
    {
        MappingGradient gradient = new SphericalMapping().Gradient(SurfacePosition.At(x, y, z));
        Assert.Equal((1 << 20) / (2 * Math.PI), gradient.U.Length, 1e-6);
        Assert.Equal(1 / Math.PI, gradient.V.Length, 1e-12);
    }

    [Fact]
    public void Over_TwoSteps_IsTheChangeOfCoordinates() => Assert.Equal(
        new TextureFootprint(2, 10, 3, 12),
        new MappingGradient(new Vector3D(1, 0, 3), new Vector3D(5, 4, 0)).Over(new Vector3D(2, 0, 0), new Vector3D(0, 3, 1)));

    [Fact]
    public void UvTransform_Footprint_IsScaledAndTurnedNotMoved()
    {
        UvTransform transform = new(new TextureCoordinate(7, 8), 90, new TextureCoordinate(2, 3), new TextureCoordinate(0.5, 0.5));

        // Scale 2 and 3, then a quarter turn: (u, v) -> (-3 v, 2 u).
        Assert.Equal(new TextureFootprint(-6, 2, -12, 6), transform.Apply(new TextureFootprint(1, 2, 3, 4)));
    }

    private static Vector3D Vector(OracleRow row, int first) => new(row.Results[first].Nearest, row.Results[first + 1].Nearest, row.Results[first + 2].Nearest);

    private static void Within(OracleRow row, Vector3D expected, Vector3D actual, double bound) =>
        Assert.True((actual - expected).Length <= bound * expected.Length, $"{row.Name} {string.Join(' ', row.Inputs)}: {actual} instead of {expected}.");

    /// <summary>A student's mapping: it only knows its coordinates.</summary>
    private sealed class ByDifferences(IMapping mapping) : IMapping
    {
        public TextureCoordinate Map(in SurfacePosition position) => mapping.Map(position);
    }
}
