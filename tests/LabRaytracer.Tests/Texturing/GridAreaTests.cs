namespace LabRaytracer.Tests.Texturing;

/// <summary>The numbered grid filtered over footprints.</summary>
public sealed class GridAreaTests
{
    private static readonly GridTexture s_points = new(), s_grid = new() { Filter = PatternFilter.Area };

    // Paper is 0.82 of red, ink 0.02. Lines are 0.06 of a cell wide and leave 0.94 x 0.94 of it; the number 1 has 8 dots of 81 to a cell.
    [Theory]
    [InlineData(3, 4.07, 0.2, 0.05, 0.58)]
    [InlineData(3, 4.07, 0.03, 0.05, 0.02)]
    [InlineData(3.03, 4.07, 0.04, 0.02, 0.42)]
    [InlineData(1.5, 2.5, 1, 1, 0.6478676543209877)]
    [InlineData(1.5, 2.5, 0.94, 0.94, 0.7305790564972698)]
    [InlineData(25.5, 2.5, 1, 1, 0.6478676543209877)]
    [InlineData(-22.5, -9.5, 1, 1, 0.6478676543209877)]
    public void Sample_BoxAlongTheAxes_IsTheExactMean(double x, double y, double width, double height, double expected)
    {
        Assert.Equal(expected, Sample(x, y, new TextureFootprint(width / 24, 0, 0, height / 12)).R, 1e-6);
        Assert.Equal(expected, Sample(x, y, new TextureFootprint(0, height / 12, width / 24, 0)).R, 1e-6);
    }

    [Theory]
    [InlineData(1, 1)]
    [InlineData(7, 0.3)]
    [InlineData(0.5, 5.3)]
    public void Sample_AnyBox_IsTheMeanOfManyPoints(double width, double height)
    {
        // 450 x 450 points cut edges at their own steps: within 1e-2 of the integral.
        TextureFootprint footprint = new(width / 24, 0, 0, height / 12);
        for (int k = 0; k < 6; k++)
        {
            (double x, double y) = (k * 4.37, k * 2.11);
            Intensity expected = MeanOfPoints(x, y, footprint, 450), mean = Sample(x, y, footprint);
            Assert.Equal(expected.R, mean.R, 1e-2);
            Assert.Equal(expected.G, mean.G, 1e-2);
            Assert.Equal(expected.B, mean.B, 1e-2);
        }
    }

    [Fact]
    public void Sample_AnyParallelogram_IsNearTheMeanOfManyPoints()
    {
        Random random = new(4);
        double squares = 0;
        for (int k = 0; k < 60; k++)
        {
            double Number() => (random.NextDouble() - 0.5) * 0.2;
            TextureFootprint footprint = new(Number(), Number(), Number(), Number());
            (double x, double y) = (24 * random.NextDouble(), 12 * random.NextDouble());
            double error = Sample(x, y, footprint).G - MeanOfPoints(x, y, footprint, 150).G;
            squares += error * error;
        }

        Assert.InRange(Math.Sqrt(squares / 60), 0, 0.02);
    }

    [Fact]
    public void Sample_WholeTile_IsTheMeanWhateverTheCentre()
    {
        TextureFootprint tile = new(1, 0, 0, 1);
        Intensity mean = Sample(0, 0, tile);
        foreach ((double x, double y) in new[] { (3.3, 4.4), (11.2, 7.9), (100.7, -55.5) })
        {
            Intensity color = Sample(x, y, tile);
            Assert.Equal(mean.R, color.R, 1e-6);
            Assert.Equal(mean.G, color.G, 1e-6);
            Assert.Equal(mean.B, color.B, 1e-6);
        }
    }

    [Fact]
    public void Sample_NoFootprint_IsThePoint()
    {
        for (int k = 0; k < 300; k++)
        {
            TextureLookup lookup = TextureLookup.At((k * 0.0371) - 3, (k * 0.0217) - 2);
            Assert.Equal(s_points.Sample(lookup), s_grid.Sample(lookup));
        }
    }

    [Fact]
    public void Sample_AcrossThePole_GoesOnAtTheOtherSide()
    {
        // The half beyond the pole is the box below it, half a turn away.
        TextureLookup At(double u, double v, double height) =>
            new(new TextureCoordinate(u, v), WrapU: TextureWrap.Repeat, WrapV: TextureWrap.Pole, Footprint: new TextureFootprint(0.03, 0, 0, height));
        for (int k = 0; k < 10; k++)
        {
            double u = 0.017 + (k * 0.1);
            Intensity north = s_grid.Sample(At(u, 1, 0.2)), south = s_grid.Sample(At(u, 0, 0.2));
            Intensity expectedNorth = (s_grid.Sample(At(u, 0.95, 0.1)) + s_grid.Sample(At(u + 0.5, 0.95, 0.1))) * 0.5f;
            Intensity expectedSouth = (s_grid.Sample(At(u, 0.05, 0.1)) + s_grid.Sample(At(u + 0.5, 0.05, 0.1))) * 0.5f;
            Assert.Equal(expectedNorth.R, north.R, 1e-6);
            Assert.Equal(expectedSouth.G, south.G, 1e-6);
        }
    }

    [Fact]
    public void Sample_ClampedV_StaysInTheOuterRow()
    {
        // Without lines a strip beyond the top is the uppermost row of dots of yellow cells, which is paper of signs: all yellow.
        GridTexture grid = new() { LineWidth = 0, Filter = PatternFilter.Area };
        Intensity color = grid.Sample(new TextureLookup(
            new TextureCoordinate(5.5 / 24, 1), WrapU: TextureWrap.Repeat, WrapV: TextureWrap.Clamp, Footprint: new TextureFootprint(0.5 / 24, 0, 0, 0.1 / 12)));
        Assert.Equal(0.9, color.R, 1e-6);
        Assert.Equal(0.68, color.G, 1e-6);
    }

    [Theory]
    [InlineData(TextureWrap.Repeat)]
    [InlineData(TextureWrap.Clamp)]
    [InlineData(TextureWrap.Pole)]
    public void Sample_EveryWidth_SameBitsAsSingleCall(TextureWrap wrapV) =>
        SamplerRun.SameAsScalar(s_grid, [.. SamplerRun.FootprintLookups(TextureWrap.Repeat, wrapV).Where(lookup => Math.Abs(lookup.Coordinate.U) < 1e6 && Math.Abs(lookup.Coordinate.V) < 1e6)]);

    private static Intensity Sample(double x, double y, in TextureFootprint footprint) => s_grid.Sample(TextureLookup.At(x / 24, y / 12) with { Footprint = footprint });

    private static Intensity MeanOfPoints(double x, double y, in TextureFootprint footprint, int side)
    {
        Intensity sum = Intensity.Black;
        for (int i = 0; i < side * side; i++)
        {
            double s = (((i % side) + 0.5) / side) - 0.5, t = (((i / side) + 0.5) / side) - 0.5;
            sum += s_points.Sample(TextureLookup.At(
                (x / 24) + (s * footprint.DuDx) + (t * footprint.DuDy), (y / 12) + (s * footprint.DvDx) + (t * footprint.DvDy)));
        }

        return sum * (1f / (side * side));
    }
}
