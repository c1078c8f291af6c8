namespace LabRaytracer.Tests.Texturing;

/// <summary>Textures that are computed.</summary>
public sealed class ProceduralTests
{
    [Theory]
    [InlineData(0.1, 0.1, 1)]
    [InlineData(0.6, 0.1, 0)]
    [InlineData(0.6, 0.6, 1)]
    [InlineData(-0.1, 0.1, 0)]
    [InlineData(-0.1, -0.1, 1)]
    public void Checker_CellsOfHalf_AlternateAlsoBelowZero(double u, double v, float expected) =>
        Assert.Equal(expected, new CheckerTexture { Columns = 2, Rows = 2 }.Sample(TextureLookup.At(u, v)).R);

    [Fact]
    public void VolumeChecker_FloorOnACellBoundary_TakesTheSideBelow()
    {
        var checker = new CheckerTexture { Space = CheckerSpace.Local, Columns = 1, Rows = 1 };
        Intensity floor = checker.Sample(TextureLookup.At(new Point3D(0.5, 0, 0.5), Vector3D.UnitY));
        Assert.Equal(checker.Sample(TextureLookup.At(new Point3D(0.5, -0.5, 0.5), Vector3D.UnitY)), floor);
        Assert.NotEqual(checker.Sample(TextureLookup.At(new Point3D(0.5, 0.5, 0.5), Vector3D.UnitY)), floor);
    }

    [Fact]
    public void Grid_HasTheColoursOfFigureSeven()
    {
        // Beside the lines, in the corner of a cell where no glyph is drawn.
        var grid = new GridTexture { Columns = 24, Rows = 12 };
        Intensity Cell(int column, int row) => grid.Sample(TextureLookup.At((column + 0.05) / 24, (row + 0.05) / 12));
        Assert.All(Enumerable.Range(0, 12), row => Assert.True(Cell(0, row).R > 10 * Cell(0, row).G));
        Assert.All(Enumerable.Range(0, 12), row => Assert.True(Cell(23, row).G > 5 * Cell(23, row).R));
        Assert.All(Enumerable.Range(1, 22), column => Assert.True(Cell(column, 0).R > 10 * Cell(column, 0).B && Cell(column, 11).G > 10 * Cell(column, 11).B));
        Assert.All(Enumerable.Range(1, 10), row => Assert.True(Cell(5, row).B > 0.7f));
    }

    [Fact]
    public void Constant_NeedsNothing()
    {
        var constant = new ConstantTexture(new Intensity(0.1f, 2, -1));
        Assert.Equal(TextureNeeds.None, constant.Needs);
        Assert.Equal(new Intensity(0.1f, 2, -1), constant.Sample(TextureLookup.At(double.NaN, 3)));
    }

    [Fact]
    public void Options_OutsideTheirRanges_AreRefused()
    {
        Assert.Throws<ArgumentOutOfRangeException>(() => new CheckerTexture { Columns = 0 });
        Assert.Throws<ArgumentOutOfRangeException>(() => new CheckerTexture { LineWidth = double.NaN });
        Assert.Throws<ArgumentOutOfRangeException>(() => new GridTexture { Rows = 101 });
        Assert.Throws<ArgumentOutOfRangeException>(() => new GridTexture { LineWidth = -0.1 });
        ArgumentOutOfRangeException failure = Assert.Throws<ArgumentOutOfRangeException>(() => new SamplingOptions { Filter = (TextureFilter)9 });
        Assert.Contains("Allowed: Nearest, Bilinear", failure.Message, StringComparison.Ordinal);
    }
}
