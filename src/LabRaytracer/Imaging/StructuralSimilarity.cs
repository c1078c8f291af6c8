namespace LabRaytracer;

/// <summary>Mean structural similarity (Wang et al., 2004, equation 13) of two luma planes in [0, 1].</summary>
internal static class StructuralSimilarity
{
    private const double C1 = 0.01 * 0.01;
    private const double C2 = 0.03 * 0.03;

    // exp(-k^2 / 4.5) for k = 0..5, divided by the sum over k = -5..5 (mpmath, 40 digits).
    private static readonly double[] HalfWindow =
        [0.26601172486179434, 0.2130055377112537, 0.10936068950970001, 0.036000772128430824, 0.0075987581352391842, 0.0010283800844791099];

    /// <summary>The mean over all windows that lie inside the pictures.</summary>
    public static double Mean(DisplayPlanes a, DisplayPlanes b)
    {
        double[] across = Window(a.Width);
        double[] down = Window(a.Height);
        int columns = a.Width - across.Length + 1;
        int rows = a.Height - down.Length + 1;

        // The last rows smoothed across, in a ring: five moments for each window column.
        double[][] ring = new double[down.Length][];
        double sum = 0;
        for (int y = 0; y < a.Height; y++)
        {
            double[] moments = ring[y % down.Length] ??= new double[5 * columns];
            SmoothRow(a, b, y, across, moments);
            if (y >= down.Length - 1)
            {
                sum += RowSum(ring, down, y, columns);
            }
        }

        return sum / ((double)columns * rows);
    }

    private static double[] Window(int side)
    {
        if (side < 11)
        {
            double[] even = new double[side];
            Array.Fill(even, 1.0 / side);
            return even;
        }

        double[] window = new double[11];
        for (int k = 0; k < 11; k++)
        {
            window[k] = HalfWindow[Math.Abs(k - 5)];
        }

        return window;
    }

    private static void SmoothRow(DisplayPlanes a, DisplayPlanes b, int y, double[] window, double[] moments)
    {
        Array.Clear(moments);
        for (int x = 0; x < a.Width; x++)
        {
            double p = a.Luma(x, y);
            double q = b.Luma(x, y);
            int first = Math.Max(0, x - window.Length + 1);
            int last = Math.Min(x, (moments.Length / 5) - 1);
            for (int column = first; column <= last; column++)
            {
                double weight = window[x - column];
                Span<double> m = moments.AsSpan(5 * column, 5);
                m[0] += weight * p;
                m[1] += weight * q;
                m[2] += weight * p * p;
                m[3] += weight * q * q;
                m[4] += weight * p * q;
            }
        }
    }

    private static double RowSum(double[][] ring, double[] window, int lastRow, int columns)
    {
        double sum = 0;
        Span<double> m = stackalloc double[5];
        for (int column = 0; column < columns; column++)
        {
            m.Clear();
            for (int k = 0; k < window.Length; k++)
            {
                double[] row = ring[(lastRow - window.Length + 1 + k) % window.Length];
                for (int i = 0; i < 5; i++)
                {
                    m[i] += window[k] * row[(5 * column) + i];
                }
            }

            sum += Similarity(m[0], m[1], m[2] - (m[0] * m[0]), m[3] - (m[1] * m[1]), m[4] - (m[0] * m[1]));
        }

        return sum;
    }

    private static double Similarity(double meanA, double meanB, double varianceA, double varianceB, double covariance) =>
        ((2 * meanA * meanB) + C1) * ((2 * covariance) + C2)
        / (((meanA * meanA) + (meanB * meanB) + C1) * (varianceA + varianceB + C2));
}
