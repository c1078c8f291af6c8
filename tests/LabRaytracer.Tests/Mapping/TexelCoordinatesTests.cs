namespace LabRaytracer.Tests;

/// <summary>Program 2 of the sheet: rows computed by hand from its text.</summary>
public sealed class TexelCoordinatesTests
{
    [Theory]
    [InlineData(0, 0, 1, 127, 0)] // u = 0, v = 1/2: (int)(255 / 2), column 0
    [InlineData(1, 0, 0, 127, 127)] // u = 1/4: (int)(511 / 4)
    [InlineData(0, 0, -1, 127, 255)] // u = 1/2: (int)(511 / 2)
    [InlineData(-1, 0, 0, 127, 383)] // u = 3/4: (int)(1533 / 4)
    [InlineData(0, 1, 0, 255, 0)] // v = 1: the top row
    [InlineData(0, -1, 0, 0, 0)] // v = 0: the bottom row
    public void GetTexelCoordinates_UnitSpherePoint_MatchesProgramTwo(double x, double y, double z, int row, int column)
    {
        TexelCoordinates.GetTexelCoordinates(new Point3D(x, y, z), 512, 256, out int foundRow, out int foundColumn);
        Assert.Equal((row, column), (foundRow, foundColumn));
    }

    [Theory]
    [InlineData(0, 1)]
    [InlineData(1, 0)]
    [InlineData(-5, 5)]
    public void GetTexelCoordinates_EmptyPicture_Throws(int xres, int yres) =>
        Assert.Throws<ArgumentOutOfRangeException>(() => TexelCoordinates.GetTexelCoordinates(new Point3D(0, 0, 1), xres, yres, out _, out _));
}
