namespace LabRaytracer;

/// <summary>A table of the sky from which directions are drawn in proportion to luminance: lat-long cells, even inside of each.</summary>
/// <remarks>
/// Immutable, thread safe. The density per steradian of a cell is its luminance over the sum of luminance x solid angle, so the density in (u, v) is proportional to
/// luminance x sin(theta) (Pharr, Jakob and Humphreys, Physically Based Rendering). Rows first, then columns inside of the row, each by inverting
/// the sums of its cells: points that fill the unit square evenly fill the sky evenly too.
/// </remarks>
internal sealed class EnvironmentTable
{
    private readonly double[] _cosines;
    private readonly StepDistribution _rows;
    private readonly StepDistribution[] _columns;

    /// <param name="luminance">Mean luminance of the cells, [row, column], rows from +Y down; at least 0.</param>
    /// <param name="even">Share of samples that are drawn evenly, [0, 1).</param>
    public EnvironmentTable(double[,] luminance, double even)
    {
        (Rows, Columns) = (luminance.GetLength(0), luminance.GetLength(1));
        _cosines = new double[Rows + 1];
        for (int row = 0; row <= Rows; row++)
        {
            _cosines[row] = Elementary.SinCosTurns(new Double1(0.5 * row / Rows)).Cos.Value;
        }

        double sum = 0;
        for (int row = 0; row < Rows; row++)
        {
            sum += SolidAngle(row) * Enumerable.Range(0, Columns).Sum(column => luminance[row, column]);
        }

        // The whole sphere has 4 pi steradians, 4 in units of pi.
        double floor = even * sum / 4;
        _columns = new StepDistribution[Rows];
        double[] rows = new double[Rows];
        for (int row = 0; row < Rows; row++)
        {
            double[] cells = new double[Columns];
            for (int column = 0; column < Columns; column++)
            {
                cells[column] = floor + ((1 - even) * luminance[row, column]);
            }

            _columns[row] = new StepDistribution(cells);
            rows[row] = SolidAngle(row) * _columns[row].Total;
        }

        _rows = new StepDistribution(rows);
    }

    /// <summary>Number of columns.</summary>
    public int Columns { get; }

    /// <summary>Number of rows.</summary>
    public int Rows { get; }

    /// <summary>Tells whether no light comes from anywhere.</summary>
    public bool IsBlack => _rows.Total == 0;

    /// <summary>The direction of a point of the unit square.</summary>
    /// <param name="s">First coordinate, [0, 1): around.</param>
    /// <param name="t">Second coordinate, [0, 1): down.</param>
    public EnvironmentSample Sample(double s, double t)
    {
        int row = _rows.Find(t, out double down, out double rowShare);
        int column = _columns[row].Find(s, out double along, out double columnShare);
        double cosine = _cosines[row] + (down * (_cosines[row + 1] - _cosines[row]));
        return new EnvironmentSample((column + along) / Columns, cosine, SolidAngle(row) / (rowShare * columnShare));
    }

    /// <summary>Probability of a cell.</summary>
    public double Probability(int row, int column) => _rows.Share(row) * _columns[row].Share(column);

    /// <summary>Solid angle of each cell of a row, in units of pi steradians.</summary>
    public double SolidAngle(int row) => 2 * (_cosines[row] - _cosines[row + 1]) / Columns;
}
