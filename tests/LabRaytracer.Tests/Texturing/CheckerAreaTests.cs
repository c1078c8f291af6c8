namespace LabRaytracer.Tests.Texturing;

/// <summary>Checkers filtered over footprints.</summary>
public sealed class CheckerAreaTests
{
    private static readonly CheckerTexture s_board = new() { Columns = 4, Rows = 8, Filter = PatternFilter.Area };

    // Exact: the product of the waves' means over the box, by hand. Columns are 1/4 wide, rows 1/8.
    [Theory]
    [InlineData(0.125, 0.0625, 0.1, 0.05, 1)]
    [InlineData(0.25, 0.0625, 0.1, 0.05, 0.5)]
    [InlineData(0.25, 0.125, 0.1, 0.05, 0.5)]
    [InlineData(0.125, 0.0625, 0.5, 0.05, 0.5)]
    [InlineData(0.125, 0.0625, 0.75, 0.125, 0.33333333333333333)]
    [InlineData(0.125, 0.0625, 0.75, 0.375, 0.55555555555555556)]
    [InlineData(0.3, 0.0625, 0.3, 0.0625, 0.33333333333333333)]
    [InlineData(-0.7, -3.9375, 0.3, 0.0625, 0.33333333333333333)]
    public void Sample_BoxAlongTheAxes_IsTheExactMean(double u, double v, double width, double height, double expected)
    {
        TextureFootprint along = new(width, 0, 0, height), turned = new(0, height, width, 0);
        Assert.Equal(expected, Sample(s_board, u, v, along), 1e-6);
        Assert.Equal(expected, Sample(s_board, u, v, turned), 1e-6);
    }

    [Fact]
    public void Sample_AnyParallelogram_IsNearTheMeanOfManyPoints()
    {
        // 200 x 200 points are within 1/100 of the integral. What is neglected, the slant of pieces, is largest for fat footprints of one or two cells.
        var random = new Random(3);
        double squares = 0;
        for (int i = 0; i < 60; i++)
        {
            double Number() => (random.NextDouble() - 0.5) * 0.8;
            TextureFootprint footprint = new(Number(), Number(), Number(), Number());
            (double u, double v) = (random.NextDouble(), random.NextDouble());
            double error = Sample(s_board, u, v, footprint) - MeanOfPoints(u, v, footprint);
            Assert.InRange(error, -0.2, 0.2);
            squares += error * error;
        }

        Assert.InRange(Math.Sqrt(squares / 60), 0, 0.05);
    }

    [Fact]
    public void Sample_ThinDiagonals_KeepTheirContrast()
    {
        // Squares in texture space; thin footprints along a diagonal lie in cells of one colour, however long they are: a box around them would be grey. Pieces of a quarter of a cell round the corners off.
        CheckerTexture squares = new() { Columns = 8, Rows = 8, Filter = PatternFilter.Area };
        TextureFootprint diagonal = new(0.9, 0.9, 0.001, -0.001);
        Assert.InRange(Sample(squares, 0.5, 0.5, diagonal), 0.85, 1);
        Assert.InRange(Sample(squares, 0.5, 0.625, diagonal), 0, 0.15);
    }

    [Fact]
    public void Sample_HugeAndOddFootprints_AreGrey()
    {
        foreach (double side in new[] { 1e3, 1e9, 1e300, double.PositiveInfinity })
        {
            Assert.Equal(0.5, Sample(s_board, 0.1, 0.2, new TextureFootprint(side, 0, 0, side)), 0.01);
            Assert.Equal(0.5, Sample(s_board, 0.1, 0.2, new TextureFootprint(side, side, 1e-3, 0)), 0.06);
        }
    }

    [Fact]
    public void Sample_NoFootprint_IsThePoint()
    {
        CheckerTexture lined = new() { Columns = 3, Rows = 5, LineWidth = 0.2, Line = new Intensity(1, 0, 0), Odd = new Intensity(0, 0, 1) };
        CheckerTexture area = new() { Columns = 3, Rows = 5, LineWidth = 0.2, Line = new Intensity(1, 0, 0), Odd = new Intensity(0, 0, 1), Filter = PatternFilter.Area };
        for (int i = 0; i < 300; i++)
        {
            TextureLookup lookup = TextureLookup.At((i * 0.0371) - 3, (i * 0.0217) - 2);
            Assert.Equal(lined.Sample(lookup), area.Sample(lookup));
        }
    }

    [Fact]
    public void Sample_Lines_HaveTheirShare()
    {
        // One cell: lines of width 0.2 leave 0.8 x 0.8. Over one whole period of two cells both colours share the rest.
        CheckerTexture lined = new() { Columns = 1, Rows = 1, LineWidth = 0.2, Even = new Intensity(1, 0, 0), Odd = new Intensity(0, 1, 0), Line = new Intensity(0, 0, 1), Filter = PatternFilter.Area };
        Intensity cell = lined.Sample(TextureLookup.At(0.5, 0.5) with { Footprint = new TextureFootprint(1, 0, 0, 1) });
        Near(new Intensity(0.64f, 0, 0.36f), cell);
        Near(new Intensity(0.32f, 0.32f, 0.36f), lined.Sample(TextureLookup.At(0.3, 0.9) with { Footprint = new TextureFootprint(2, 0, 0, 2) }));
    }

    [Fact]
    public void Sample_Volume_BoxesAndBoundaries()
    {
        CheckerTexture cubes = new() { Space = CheckerSpace.Local, Columns = 1, Rows = 1, Filter = PatternFilter.Area };

        // On the boundary y = 0 of a floor the cell below it counts; half over the edge x = 1 both cells share.
        TextureLookup floor = TextureLookup.At(new Point3D(0.5, 0, 0.5), Vector3D.UnitY);
        SurfaceFootprint small = new(new Vector3D(0.2, 0, 0), new Vector3D(0, 0, 0.3));
        Assert.Equal(0, cubes.Sample(floor with { LocalFootprint = small }).R, 1e-6f);
        Assert.Equal(0.5f, cubes.Sample(floor with { LocalPoint = new Point3D(1, 0, 0.5), LocalFootprint = small }).R, 1e-6f);
        Assert.Equal(0.25f, cubes.Sample(floor with { LocalPoint = new Point3D(0.95, 0, 0.5), LocalFootprint = small }).R, 1e-6f);
    }

    [Fact]
    public void Batch_AllWidths_SameAsScalar()
    {
        foreach (CheckerTexture checker in new[]
        {
            new CheckerTexture { Columns = 3, Rows = 5, LineWidth = 0.1, Line = new Intensity(1, 0, 0), Filter = PatternFilter.Area },
            new CheckerTexture { Columns = 30, Rows = 50, Filter = PatternFilter.Area },
            new CheckerTexture { Space = CheckerSpace.Local, Columns = 2, Rows = 3, Filter = PatternFilter.Area },
        })
        {
            SamplerRun.SameAsScalar(checker, SamplerRun.FootprintLookups(TextureWrap.Repeat, TextureWrap.Repeat));
        }
    }

    [Fact]
    public void Render_FineCheckerToTheHorizon_OneSampleBeatsSixtyFour()
    {
        Scene Floor(PatternFilter filter)
        {
            var scene = new Scene { Camera = new PerspectiveCamera(new Point3D(0, 0, 5), new Point3D(0, -0.15, 4), 40), Background = Intensity.Grey(0.5f) };
            scene.Add(new InfinitePlane(new Point3D(0, -1, 0), Vector3D.UnitY), new Material { Diffuse = Intensity.Black, Emission = TextureSlot.Of(new CheckerTexture { Columns = 64, Rows = 64, Filter = filter }) });
            return scene;
        }

        Picture Render(PatternFilter filter, int samples, int seed = 0) => Renderer.Render(Floor(filter), new RenderOptions
        {
            Width = 96, Height = 54, Samples = samples, Pattern = samples == 1 ? SamplePattern.Regular : SamplePattern.Jittered, Seed = seed,
        }).Picture;
        Picture converged = Render(PatternFilter.Nearest, 1024, seed: 1);
        double filtered = PictureAssert.Rmse(converged, Render(PatternFilter.Area, 1)), plain = PictureAssert.Rmse(converged, Render(PatternFilter.Nearest, 64));
        Assert.True(filtered < 0.8 * plain, $"{filtered} {plain}");
    }

    private static void Near(Intensity expected, Intensity actual)
    {
        Assert.Equal(expected.R, actual.R, 1e-6f);
        Assert.Equal(expected.G, actual.G, 1e-6f);
        Assert.Equal(expected.B, actual.B, 1e-6f);
    }

    private static double Sample(CheckerTexture checker, double u, double v, TextureFootprint footprint) => checker.Sample(TextureLookup.At(u, v) with { Footprint = footprint }).G;

    private static double MeanOfPoints(double u, double v, TextureFootprint footprint)
    {
        const int Side = 200;
        int even = 0;
        for (int i = 0; i < Side * Side; i++)
        {
            double p = (((i % Side) + 0.5) / Side) - 0.5, q = (((i / Side) + 0.5) / Side) - 0.5;
            double atU = u + (p * footprint.DuDx) + (q * footprint.DuDy), atV = v + (p * footprint.DvDx) + (q * footprint.DvDy);
            even += ((int)Math.Floor(4 * atU) + (int)Math.Floor(8 * atV)) % 2 == 0 ? 1 : 0;
        }

        return (double)even / (Side * Side);
    }
}
