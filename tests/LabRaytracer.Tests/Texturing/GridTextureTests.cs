namespace LabRaytracer.Tests.Texturing;

public sealed class GridTextureTests
{
    private static readonly GridTexture s_grid = new();

    /// <summary>Near the corner of a cell, inside its lines and beside its sign.</summary>
    [Theory]
    [InlineData(0, 0, "red")]
    [InlineData(0, 5, "red")]
    [InlineData(0, 11, "red")]
    [InlineData(23, 0, "green")]
    [InlineData(23, 11, "green")]
    [InlineData(1, 0, "yellow")]
    [InlineData(22, 11, "yellow")]
    [InlineData(1, 1, "paper")]
    [InlineData(22, 10, "paper")]
    [InlineData(11, 6, "paper")]
    public void Sample_CornerOfACell_HasTheColourOfTheSheet(int column, int row, string expected) =>
        Assert.Equal(expected, Name(Color(s_grid, column + 0.07, row + 0.07)));

    [Theory]
    [InlineData(3, 4)]
    [InlineData(0, 0)]
    [InlineData(24, 12)]
    [InlineData(3.5, 4)]
    [InlineData(3, 4.5)]
    public void Sample_OnALine_IsInk(double x, double y) => Assert.Equal("ink", Name(Color(s_grid, x, y)));

    /// <summary>Cell (1, 2) has an odd sum: its column's number, 1. Dots of the 9 x 9 raster, from the bottom left.</summary>
    [Theory]
    [InlineData(3, 2, true)]
    [InlineData(4, 2, true)]
    [InlineData(5, 2, true)]
    [InlineData(4, 4, true)]
    [InlineData(4, 6, true)]
    [InlineData(3, 5, true)]
    [InlineData(5, 5, false)]
    [InlineData(3, 3, false)]
    [InlineData(6, 4, false)]
    public void Sample_NumberOne_IsUpright(int dotX, int dotY, bool isInk) => Assert.Equal(isInk ? "ink" : "paper", Name(Dot(1, 2, dotX, dotY)));

    /// <summary>Cell (2, 2): sum 4, half of it even: the arrow. Wide near its upper end, a shaft below.</summary>
    [Theory]
    [InlineData(4, 7, true)]
    [InlineData(1, 4, true)]
    [InlineData(7, 4, true)]
    [InlineData(4, 1, true)]
    [InlineData(2, 2, false)]
    [InlineData(1, 7, false)]
    public void Sample_Arrow_PointsToLargerV(int dotX, int dotY, bool isInk) => Assert.Equal(isInk ? "ink" : "paper", Name(Dot(2, 2, dotX, dotY)));

    /// <summary>Cell (3, 3): sum 6, half of it odd: the letter R with its stem on the left.</summary>
    [Theory]
    [InlineData(2, 1, true)]
    [InlineData(2, 7, true)]
    [InlineData(6, 1, true)]
    [InlineData(6, 4, false)]
    [InlineData(7, 1, false)]
    [InlineData(5, 7, true)]
    public void Sample_LetterR_IsNotMirrored(int dotX, int dotY, bool isInk) => Assert.Equal(isInk ? "ink" : "paper", Name(Dot(3, 3, dotX, dotY)));

    [Fact]
    public void Sample_OutsideOneTile_Repeats()
    {
        Intensity inside = s_grid.Sample(TextureLookup.At(0.3, 0.6));
        Assert.Equal(inside, s_grid.Sample(TextureLookup.At(2.3, 0.6)));
        Assert.Equal(inside, s_grid.Sample(TextureLookup.At(-0.7, -1.4)));
    }

    [Fact]
    public void Sample_ClampedV_StaysInTheOuterRows()
    {
        GridTexture grid = new() { LineWidth = 0 };
        double u = 5.07 / 24;
        TextureLookup above = new(new TextureCoordinate(u, 7), WrapV: TextureWrap.Clamp), pole = new(new TextureCoordinate(u, 1), WrapV: TextureWrap.Clamp);
        Assert.Equal(("yellow", "yellow"), (Name(grid.Sample(above)), Name(grid.Sample(pole))));
    }

    [Fact]
    public void Render_OnAQuad_IsTheSampleInEveryPixel()
    {
        // The quad fills the picture of an eye far above its middle; batches of lanes must agree with single lookups.
        Scene scene = new() { Camera = new PerspectiveCamera(new Point3D(0, 0, 10), Point3D.Origin, 20) };
        double half = 10 * Math.Tan(10 * Math.PI / 180);
        scene.Add(
            new Quad(new Point3D(-2 * half, -half, 0), new Vector3D(0, 2 * half, 0), new Vector3D(4 * half, 0, 0)),
            new Material { Diffuse = Intensity.Black, Emission = TextureSlot.Of(s_grid) });
        Picture picture = Renderer.Render(scene, new RenderOptions { Width = 194, Height = 97 }).Picture;
        for (int y = 0; y < picture.Height; y++)
        {
            for (int x = 0; x < picture.Width; x++)
            {
                Intensity expected = s_grid.Sample(TextureLookup.At((x + 0.5) / 194, 1 - ((y + 0.5) / 97)));
                Assert.True(picture[x, y] == expected, $"pixel ({x}, {y}): {picture[x, y]} instead of {expected}");
            }
        }
    }

    [Theory]
    [InlineData(1)]
    [InlineData(101)]
    public void Columns_OutOfRange_Throw(int cells)
    {
        Assert.Throws<ArgumentOutOfRangeException>(() => new GridTexture { Columns = cells });
        Assert.Throws<ArgumentOutOfRangeException>(() => new GridTexture { Rows = cells });
    }

    [Theory]
    [InlineData(-0.1)]
    [InlineData(1.1)]
    [InlineData(double.NaN)]
    public void LineWidth_OutOfRange_Throws(double width) => Assert.Throws<ArgumentOutOfRangeException>(() => new GridTexture { LineWidth = width });

    private static Intensity Color(GridTexture grid, double x, double y) => grid.Sample(TextureLookup.At(x / grid.Columns, y / grid.Rows));

    private static Intensity Dot(int column, int row, int dotX, int dotY) => Color(s_grid, column + ((dotX + 0.5) / 9), row + ((dotY + 0.5) / 9));

    private static string Name(Intensity color) => color switch
    {
        { R: > 0.7f, G: > 0.7f, B: > 0.7f } => "paper",
        { R: > 0.7f, G: > 0.5f, B: < 0.1f } => "yellow",
        { R: > 0.5f, G: < 0.1f, B: < 0.1f } => "red",
        { R: < 0.1f, G: > 0.3f, B: < 0.1f } => "green",
        { R: < 0.1f, G: < 0.1f, B: < 0.1f } => "ink",
        _ => $"{color}",
    };
}
