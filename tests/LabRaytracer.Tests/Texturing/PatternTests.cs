namespace LabRaytracer.Tests.Texturing;

/// <summary>Marble, wood, bricks, gradients and cells: their definitions at places where they can be worked out by hand, and their means.</summary>
public sealed class PatternTests
{
    private static readonly ColorRamp s_plain = new(new ColorStop(0, Intensity.Black), new ColorStop(4, Intensity.Grey(4)));

    /// <summary>Without noise t = (1 + sin(2 pi 2 y)) / 2.</summary>
    [Theory]
    [InlineData(0, 0.5)]
    [InlineData(0.125, 1)]
    [InlineData(0.25, 0.5)]
    [InlineData(-0.125, 0)]
    [InlineData(1000000.125, 1)]
    [InlineData(0.0416666666666666667, 0.75)]
    public void Marble_WithoutNoise_IsASine(double y, double expected) =>
        Assert.Equal(expected, new MarbleTexture { Amount = 0, Stripes = 2, Ramp = s_plain }.Sample(TextureLookup.At(new Point3D(0.3, y, -7))).R, 1e-6);

    /// <summary>Without noise t is the fraction of 5 sqrt(x² + z²).</summary>
    [Theory]
    [InlineData(0, 0, 0)]
    [InlineData(0.3, 0.4, 0.5)]
    [InlineData(-3, 4.02, 0.08)]
    public void Wood_WithoutNoise_IsRings(double x, double z, double expected) =>
        Assert.Equal(expected, new WoodTexture { Amount = 0, Rings = 5, Ramp = s_plain }.Sample(TextureLookup.At(new Point3D(x, 17, z))).R, 2e-3);

    /// <summary>Two bricks across, four rows, mortar a fifth of a row: 0.05 of v, and of u as well.</summary>
    [Theory]
    [InlineData(0.25, 0.125, true)]
    [InlineData(0.25, 0.02, false)]
    [InlineData(0.25, 0.23, false)]
    [InlineData(0.02, 0.125, false)]
    [InlineData(0.03, 0.125, true)]
    [InlineData(0.48, 0.125, false)]
    [InlineData(0.02, 0.375, true)]
    [InlineData(0.25, 0.375, false)]
    [InlineData(-0.02, 0.125, false)]
    [InlineData(0.25, -0.125, false)]
    public void Brick_SecondRows_AreShiftedByHalf(double u, double v, bool isBrick)
    {
        var wall = new BrickTexture { Columns = 2, Rows = 4, Mortar = 0.2, Brick = Intensity.White, MortarColor = Intensity.Black };
        Assert.Equal(isBrick ? 1 : 0, wall.Sample(TextureLookup.At(u, v)).R);
    }

    [Fact]
    public void Brick_ClosedWall_ShowsTheSameBrickOnBothSidesOfTheSeam()
    {
        var wall = new BrickTexture { Variation = 1, Mortar = 0 };
        Assert.Equal(wall.Sample(TextureLookup.At(0.001, 1.5 / 16)), wall.Sample(TextureLookup.At(0.999, 1.5 / 16)));
        Assert.NotEqual(wall.Sample(TextureLookup.At(0.07, 1.5 / 16)), wall.Sample(TextureLookup.At(0.999, 1.5 / 16)));
    }

    /// <summary>Within one row the filter is the exact mean of the box: against 400 x 400 points.</summary>
    [Theory]
    [InlineData(0.3, 0.13, 0.05)]
    [InlineData(0.02, 0.1, 0.1)]
    [InlineData(0.51, 0.375, 0.2)]
    public void Brick_Filtered_IsTheMeanOfPoints(double u, double v, double width)
    {
        var wall = new BrickTexture { Columns = 2, Rows = 4, Mortar = 0.2, Brick = Intensity.White, MortarColor = Intensity.Black };
        double sum = 0;
        for (int i = 0; i < 160000; i++)
        {
            sum += wall.Sample(TextureLookup.At(u + (width * ((((i % 400) + 0.5) / 400) - 0.5)), v + (width * (((Math.Floor(i / 400.0) + 0.5) / 400) - 0.5)))).R;
        }

        TextureLookup filtered = TextureLookup.At(u, v) with { Footprint = new TextureFootprint(width, 0, 0, width) };
        Assert.Equal(sum / 160000, wall.Sample(filtered).R, 0.004);
    }

    /// <summary>Far away only the mean is left: (1 - mortar) along both axes.</summary>
    [Fact]
    public void Brick_WideFilter_IsTheShareOfBrick()
    {
        var wall = new BrickTexture { Columns = 4, Rows = 4, Mortar = 0.2, Brick = Intensity.White, MortarColor = Intensity.Black };
        Assert.Equal(0.64, wall.Sample(TextureLookup.At(0.3, 0.4) with { Footprint = new TextureFootprint(50, 0, 0, 50) }).R, 1e-3);
    }

    [Fact]
    public void Wood_WideFilter_IsTheMeanOfItsRamp()
    {
        var wood = new WoodTexture();
        Intensity far = wood.Sample(TextureLookup.At(new Point3D(0.3, 0.4, 0.5)) with { LocalFootprint = new SurfaceFootprint(new Vector3D(1, 0, 0), default) });
        Assert.Equal(wood.Ramp.Mean, far);
        Assert.Equal((0.55 + 0.24) / 2, wood.Ramp.Mean.R, 1e-6);
    }

    [Theory]
    [InlineData(GradientKind.U, 0.25)]
    [InlineData(GradientKind.V, 0.75)]
    [InlineData(GradientKind.Axis, 2.5)]
    [InlineData(GradientKind.Radial, 3)]
    public void Gradient_EveryKind_RunsAlongItsNumber(GradientKind kind, double expected)
    {
        var gradient = new GradientTexture { Kind = kind, Axis = new Vector3D(0.5, 1, 0), Center = new Point3D(0, 0, 1), Ramp = s_plain };
        Assert.Equal(expected, gradient.Sample(new TextureLookup(new TextureCoordinate(0.25, 0.75), new Point3D(1, 2, 3))).R, 1e-6);
    }

    /// <summary>The means that stand in for cells that cannot be seen, against 20000 points: within four standard errors and what the documentation rounds.</summary>
    [Theory]
    [InlineData(WorleyMetric.Euclidean)]
    [InlineData(WorleyMetric.Manhattan)]
    [InlineData(WorleyMetric.Chebyshev)]
    public void Worley_WideFilter_IsTheMean(WorleyMetric metric)
    {
        var random = new Random(12);
        foreach (PatternSpace space in Enum.GetValues<PatternSpace>())
        {
            foreach (WorleyFeature feature in Enum.GetValues<WorleyFeature>())
            {
                var cells = new WorleyTexture { Metric = metric, Feature = feature, Space = space, Frequency = 1, Ramp = s_plain };
                double Next() => (random.NextDouble() - 0.5) * 2000;
                double mean = Enumerable.Range(0, 20000).Average(_ =>
                {
                    (double x, double y, double z) = (Next(), Next(), Next());
                    return cells.Sample(new TextureLookup(new TextureCoordinate(x, y), new Point3D(x, y, z))).R;
                });
                TextureLookup far = new(new TextureCoordinate(0, 0), Point3D.Origin) { Footprint = new TextureFootprint(1, 0, 0, 1), LocalFootprint = new SurfaceFootprint(new Vector3D(1, 0, 0), default) };
                Assert.Equal(mean, cells.Sample(far).R, 0.01);
            }
        }
    }
}
