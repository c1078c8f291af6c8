namespace LabRaytracer.Tests.Lighting;

/// <summary>The table that directions are drawn from.</summary>
public sealed class EnvironmentTableTests
{
    [Theory]
    [InlineData(1, 1, 0)]
    [InlineData(7, 3, 0)]
    [InlineData(64, 32, 0.0625)]
    [InlineData(100, 51, 0)]
    public void Probability_AllCells_AddUpToOneAndFollowLuminanceTimesSolidAngle(int columns, int rows, double even)
    {
        double[,] luminance = Random(columns, rows);
        EnvironmentTable table = new(luminance, even);
        double sum = 0, light = 0, sphere = 0;
        for (int row = 0; row < rows; row++)
        {
            for (int column = 0; column < columns; column++)
            {
                sum += table.Probability(row, column);
                light += luminance[row, column] * table.SolidAngle(row);
                sphere += table.SolidAngle(row);
            }
        }

        Assert.Equal(1, sum, 1e-12);
        Assert.Equal(4, sphere, 1e-12);
        for (int row = 0; row < rows; row++)
        {
            // The exact solid angle of a cell: 2 pi / columns (cos theta1 - cos theta2).
            double exact = 2.0 / columns * (Math.Cos(Math.PI * row / rows) - Math.Cos(Math.PI * (row + 1) / rows));
            Assert.Equal(exact, table.SolidAngle(row), 1e-15);
            for (int column = 0; column < columns; column++)
            {
                double expected = (((1 - even) * luminance[row, column] / light) + (even / 4)) * exact;
                Assert.Equal(expected, table.Probability(row, column), 1e-12);
            }
        }
    }

    [Fact]
    public void Sample_EvenPoints_FallIntoCellsAsOftenAsTheirProbability()
    {
        EnvironmentTable table = new(Random(13, 5), 0);
        int[,] counts = new int[5, 13];
        const int Side = 512;
        for (int i = 0; i < Side * Side; i++)
        {
            EnvironmentSample sample = table.Sample((i % Side + 0.5) / Side, (i / Side + 0.5) / Side);
            int row = Math.Clamp((int)(Math.Acos(sample.Cosine) / Math.PI * 5), 0, 4), column = (int)(sample.Turns * 13);
            counts[row, column]++;
            Assert.Equal(table.SolidAngle(row) / table.Probability(row, column), sample.Weight, 1e-9 * sample.Weight);
        }

        for (int row = 0; row < 5; row++)
        {
            for (int column = 0; column < 13; column++)
            {
                // A grid of points misjudges an interval by at most one point in each direction.
                double expected = table.Probability(row, column) * Side * Side;
                Assert.InRange(counts[row, column], expected - (2 * Side), expected + (2 * Side));
            }
        }
    }

    [Fact]
    public void Sample_BlackCells_AreNeverDrawn()
    {
        double[,] luminance = new double[4, 8];
        luminance[2, 5] = 1e-30;
        EnvironmentTable table = new(luminance, 0);
        Assert.False(table.IsBlack);
        foreach (double s in new[] { 0, 1e-10, 0.5, 1 - 1e-10 })
        {
            EnvironmentSample sample = table.Sample(s, 1 - s - 1e-10);
            Assert.InRange(sample.Turns, 5 / 8.0, 6 / 8.0);
            Assert.InRange(sample.Cosine, -Math.Sqrt(0.5) - 1e-15, 1e-15);
            Assert.Equal(table.SolidAngle(2), sample.Weight, 1e-15);
        }

        Assert.True(new EnvironmentTable(new double[3, 3], 0.1).IsBlack);
    }

    private static double[,] Random(int columns, int rows)
    {
        Random random = new(columns);
        double[,] luminance = new double[rows, columns];
        for (int i = 0; i < rows * columns; i++)
        {
            luminance[i / columns, i % columns] = random.Next(4) == 0 ? 0 : Math.Pow(random.NextDouble(), 6);
        }

        luminance[0, 0] = 0.5;
        return luminance;
    }
}
