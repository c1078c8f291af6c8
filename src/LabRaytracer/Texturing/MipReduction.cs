namespace LabRaytracer;

/// <summary>Halves a picture: every texel is the mean over its area, also where a side is odd.</summary>
/// <remarks>
/// From n texels to max(1, floor(n / 2)). From 2m + 1 to m, texel i is the mean of texels 2i, 2i + 1, 2i + 2 with weights (m - i, m, i + 1) / (2m + 1):
/// the areas that it shares with them. So the mean of the picture stays. Sums are in doubles.
/// </remarks>
internal static unsafe class MipReduction
{
    /// <summary>Number of texels of the next level along a side.</summary>
    public static int Half(int size) => Math.Max(1, size / 2);

    /// <summary>The texels of the larger level that a texel of the smaller one covers, and their weights.</summary>
    /// <param name="size">Texels of the larger level.</param>
    /// <param name="i">Texel of the smaller level.</param>
    /// <param name="weights">Receives up to three weights, which add up to 1.</param>
    /// <returns>The first texel and how many.</returns>
    public static (int First, int Count) Taps(int size, int i, double* weights)
    {
        if (size == 1)
        {
            weights[0] = 1;
            return (0, 1);
        }

        if (size % 2 == 0)
        {
            weights[0] = weights[1] = 0.5;
            return (2 * i, 2);
        }

        int half = size / 2;
        weights[0] = (half - i) / (double)size;
        weights[1] = half / (double)size;
        weights[2] = (i + 1) / (double)size;
        return (2 * i, 3);
    }

    /// <summary>Rows [first, end) of the next level.</summary>
    /// <param name="source">The larger level.</param>
    /// <param name="first">First row of the smaller level.</param>
    /// <param name="end">Row behind the last one.</param>
    /// <param name="red">Red of the smaller level, row 0 first.</param>
    /// <param name="green">Green.</param>
    /// <param name="blue">Blue.</param>
    public static void Run(TexelRows source, int first, int end, float* red, float* green, float* blue)
    {
        using LaneMemory memory = new();
        int width = source.Width, half = Half(width);
        float* row = memory.Column<float>((3 * width) + 48, 1);
        double* sums = memory.Column<double>(3 * width, 1);
        double* weights = stackalloc double[3];
        for (int y = first; y < end; y++)
        {
            (int top, int count) = Taps(source.Height, y, weights);
            new Span<double>(sums, 3 * width).Clear();
            for (int k = 0; k < count; k++)
            {
                source.Read(top + k, row, row + width, row + (2 * width));
                double weight = weights[k];
                for (int x = 0; x < 3 * width; x++)
                {
                    sums[x] += weight * row[x];
                }
            }

            long at = (long)y * half;
            Across(sums, width, red + at);
            Across(sums + width, width, green + at);
            Across(sums + (2 * width), width, blue + at);
        }
    }

    private static void Across(double* sums, int width, float* result)
    {
        double* weights = stackalloc double[3];
        int half = Half(width);
        for (int x = 0; x < half; x++)
        {
            (int first, int count) = Taps(width, x, weights);
            double sum = 0;
            for (int k = 0; k < count; k++)
            {
                sum += weights[k] * sums[first + k];
            }

            result[x] = (float)sum;
        }
    }
}
