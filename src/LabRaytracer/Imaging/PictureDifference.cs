namespace LabRaytracer;

/// <summary>How much two pictures of one size differ, measured on displayed values: light clamped, sRGB encoded with 16 bits, scaled to [0, 1].</summary>
/// <remarks>Immutable, thread safe. The sums run in a fixed order: the same bits on every machine.</remarks>
public sealed class PictureDifference
{
    private readonly Picture squaredErrors;

    private PictureDifference(DisplayPlanes a, DisplayPlanes b)
    {
        squaredErrors = new Picture(a.Width, a.Height);
        double sum = 0;
        for (int y = 0; y < a.Height; y++)
        {
            Span<Intensity> errors = squaredErrors.Row(y);
            double rowSum = 0;
            for (int x = 0; x < errors.Length; x++)
            {
                Intensity difference = a[x, y] - b[x, y];
                Intensity squared = difference * difference;
                errors[x] = squared;
                rowSum += (double)squared.R + squared.G + squared.B;
                Max = Math.Max(Max, Math.Max(Math.Abs(difference.R), Math.Max(Math.Abs(difference.G), Math.Abs(difference.B))));
            }

            sum += rowSum;
        }

        Rmse = Math.Sqrt(sum / (3.0 * a.Width * a.Height));
        Ssim = StructuralSimilarity.Mean(a, b);
    }

    /// <summary>Root of the mean squared error over all components, [0, 1]; 1 is the distance of black and white.</summary>
    public double Rmse { get; }

    /// <summary>Peak signal-to-noise ratio, decibels: -20 log10(RMSE); positive infinity for equal pictures.</summary>
    public double Psnr => -20 * Math.Log10(Rmse);

    /// <summary>The largest absolute difference of a component, [0, 1].</summary>
    public double Max { get; }

    /// <summary>Mean structural similarity of the luma, at most 1, which equal pictures have.</summary>
    /// <remarks>
    /// Wang, Bovik, Sheikh, Simoncelli, "Image quality assessment: from error visibility to structural similarity", 2004: window 11 x 11,
    /// Gaussian of deviation 1.5, K1 = 0.01, K2 = 0.03, only windows inside the picture; smaller pictures use one window of their size, evenly weighted.
    /// </remarks>
    public double Ssim { get; }

    /// <summary>Compares two pictures.</summary>
    /// <param name="a">One picture.</param>
    /// <param name="b">The other; the order does not matter.</param>
    /// <exception cref="ArgumentException">The sizes differ.</exception>
    public static PictureDifference Compare(Picture a, Picture b)
    {
        ArgumentNullException.ThrowIfNull(a);
        ArgumentNullException.ThrowIfNull(b);
        if (a.Width != b.Width || a.Height != b.Height)
        {
            throw new ArgumentException(
                $"The pictures have different sizes, {a.Width} x {a.Height} and {b.Width} x {b.Height}; only equal sizes can be compared.",
                nameof(b));
        }

        return new PictureDifference(new DisplayPlanes(a), new DisplayPlanes(b));
    }

    /// <summary>A picture of where the error is: black = none, over blue, red and yellow to white = <paramref name="fullScale"/> or more.</summary>
    /// <param name="fullScale">Root mean square error of a pixel that is shown white, above 0; null for the largest in the picture.</param>
    /// <exception cref="ArgumentOutOfRangeException">The scale is not above 0.</exception>
    public Picture CreateHeatMap(double? fullScale = null)
    {
        if (!(fullScale is null or > 0))
        {
            throw new ArgumentOutOfRangeException(nameof(fullScale), fullScale, "The scale of a heat map must be above 0; null takes the largest error.");
        }

        Picture map = new(squaredErrors.Width, squaredErrors.Height);
        double largest = 0;
        foreach (Intensity error in squaredErrors.Pixels)
        {
            largest = Math.Max(largest, PixelError(error));
        }

        double scale = fullScale ?? largest;
        for (int i = 0; i < map.Pixels.Length && scale > 0; i++)
        {
            map.Pixels[i] = HeatScale.Color((float)Math.Min(1, PixelError(squaredErrors.Pixels[i]) / scale));
        }

        return map;
    }

    private static double PixelError(Intensity squared) => Math.Sqrt(((double)squared.R + squared.G + squared.B) / 3);
}
