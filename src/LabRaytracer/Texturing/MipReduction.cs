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
    /// <param name="stride">Floats from one of its rows to the next.</param>
    /// <param name="texels">The smaller level, row 0 first: red, green, blue, 1.</param>
    public static void Run(TexelRows source, int first, int end, int stride, float* texels)
    {
        using LaneMemory memory = new();
        int width = source.Width;
        bool isEven = width % 2 == 0 && source.Height % 2 == 0;
        float* rows = memory.Column<float>((6 * width) + 48, 1);
        double* sums = memory.Column<double>(isEven ? 1 : 3 * width, 1);
        for (int y = first; y < end; y++)
        {
            float* result = texels + ((long)y * stride);
            if (isEven)
            {
                Quarter(source, y, rows, result);
            }
            else
            {
                Weigh(source, y, rows, sums, result);
            }

            for (int x = 0; x < Half(width); x++)
            {
                result[(MipPyramid.Channels * x) + 3] = 1;
            }
        }
    }

    /// <summary>A row of means of two by two texels.</summary>
    private static void Quarter(TexelRows source, int y, float* rows, float* result)
    {
        int width = source.Width;
        float* upper = rows + (3 * width);
        source.Read(2 * y, rows, rows + width, rows + (2 * width));
        source.Read((2 * y) + 1, upper, upper + width, upper + (2 * width));
        Quarter(rows, upper, width, result);
        Quarter(rows + width, upper + width, width, result + 1);
        Quarter(rows + (2 * width), upper + (2 * width), width, result + 2);
    }

    private static void Quarter(float* lower, float* upper, int width, float* result)
    {
        for (int x = 0; x < width; x += 2)
        {
            // Halves and quarters are exact: the bits of the weighted sums of other sizes.
            result[MipPyramid.Channels / 2 * x] = (float)(0.25 * (((double)lower[x] + upper[x]) + ((double)lower[x + 1] + upper[x + 1])));
        }
    }

    /// <summary>A row of means of texels by the areas that they share.</summary>
    private static void Weigh(TexelRows source, int y, float* row, double* sums, float* result)
    {
        int width = source.Width;
        double* weights = stackalloc double[3];
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

        Across(sums, width, result);
        Across(sums + width, width, result + 1);
        Across(sums + (2 * width), width, result + 2);
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

            result[MipPyramid.Channels * x] = (float)sum;
        }
    }
}
