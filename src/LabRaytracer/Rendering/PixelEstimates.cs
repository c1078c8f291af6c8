namespace LabRaytracer;

/// <summary>The pixels of a tile while their samples come in: means, and how far they may be off.</summary>
/// <remarks>
/// <para>Numbers of samples are powers of two, and both halves of a pixel's samples are spread evenly over its filter. So the difference of the halves' means
/// shows how much even spreading helps: a quarter of its square is the squared error, if the halves knew nothing of each other. As they complement
/// one another, errors are rather over- than underestimated.</para>
/// <para>A pixel that an edge barely touches may look as flat as one without an edge. Until its samples are doubled for the first time, its error is therefore
/// the variance of its samples, shared with its neighbours, times what the halves of all pixels of the tile say about such variances.</para>
/// <para>Errors are those of linear light, the mean of the three components' squares. Sums run in the order of samples and pixels.</para>
/// </remarks>
/// <param name="side">Width and height of the tile, pixels.</param>
/// <param name="gain">Weight of a signed sample, <see cref="PixelWarp.Gain"/>.</param>
internal sealed class PixelEstimates(int side, double gain)
{
    /// <summary>Fewest samples of a pixel.</summary>
    public const int Fewest = 4;

    private readonly Entry[] _pixels = new Entry[side * side];
    private readonly double[] _variances = new double[side * side];
    private readonly double[] _spread = new double[side * side];
    private int _width;
    private int _height;
    private int _firstSamples;
    private double _evenness;

    /// <summary>Starts a tile.</summary>
    /// <param name="width">Columns inside the picture.</param>
    /// <param name="height">Rows inside the picture.</param>
    /// <param name="firstSamples">Samples that every pixel takes.</param>
    public void Start(int width, int height, int firstSamples)
    {
        Array.Clear(_pixels);
        (_width, _height, _firstSamples, _evenness) = (width, height, firstSamples, 0);
    }

    /// <summary>Samples of a pixel so far.</summary>
    public int Count(int x, int y) => At(x, y).Count;

    /// <summary>Adds the next sample of a pixel.</summary>
    public void Add(int x, int y, Intensity light, bool isNegative)
    {
        ref Entry pixel = ref At(x, y);
        pixel.Sum += light;
        pixel.Signed = isNegative ? pixel.Signed - light : pixel.Signed + light;
        pixel.Negative += isNegative ? 1 : 0;
        pixel.Squares += Square(light);
        pixel.Count++;
        if (int.IsPow2(pixel.Count))
        {
            (pixel.Half, pixel.Whole) = (pixel.Whole, pixel.Sum);
        }
    }

    /// <summary>The pixel's light.</summary>
    /// <remarks>
    /// With a filter that is nowhere negative the mean. Otherwise the signed mean plus what its weights leave of 1 times the plain mean: a constant picture
    /// stays constant, and nothing is divided by a sum of weights that could be 0.
    /// </remarks>
    public Intensity Mean(int x, int y)
    {
        ref Entry pixel = ref At(x, y);
        float share = 1f / pixel.Count;
        if (gain == 1)
        {
            return pixel.Sum * share;
        }

        float signed = (float)(gain * (pixel.Count - (2 * pixel.Negative)) / pixel.Count);
        return (pixel.Signed * ((float)gain * share)) + (pixel.Sum * ((1 - signed) * share));
    }

    /// <summary>Sum of the pixels' estimated squared errors.</summary>
    public double SquaredError()
    {
        Spread();
        if (_evenness == 0)
        {
            (double halves, double variances) = (Sum(pixel => pixel.Difference()), Sum(pixel => pixel.Variance() / pixel.Count));
            _evenness = halves > 0 && halves < variances ? halves / variances : 1;
        }

        double sum = 0;
        for (int y = 0; y < _height; y++)
        {
            for (int x = 0; x < _width; x++)
            {
                sum += ErrorOf(At(x, y), _spread[(y * side) + x]);
            }
        }

        return sum;
    }

    /// <summary>The pixels in which one more sample lowers the picture's error most; after <see cref="SquaredError"/>.</summary>
    /// <param name="most">Most samples of a pixel; each that is chosen will get as many more as it has.</param>
    /// <param name="chosen">Receives columns and rows.</param>
    public void Choose(int most, List<(int X, int Y)> chosen)
    {
        // A squared error of s / n falls by s / n^2 a sample; all pixels within a quarter of the largest fall are served at once.
        double largest = 0;
        for (int y = 0; y < _height; y++)
        {
            for (int x = 0; x < _width; x++)
            {
                largest = Math.Max(largest, Fall(x, y, most));
            }
        }

        chosen.Clear();
        for (int y = 0; y < _height && largest > 0; y++)
        {
            for (int x = 0; x < _width; x++)
            {
                if (Fall(x, y, most) > largest / 4)
                {
                    chosen.Add((x, y));
                }
            }
        }
    }

    private double Fall(int x, int y, int most)
    {
        double count = At(x, y).Count;
        return 2 * count > most ? 0 : _spread[(y * side) + x] / (count * count);
    }

    /// <summary>Variances of the samples, half of each pixel's replaced by the mean of its neighbours.</summary>
    private void Spread()
    {
        for (int y = 0; y < _height; y++)
        {
            for (int x = 0; x < _width; x++)
            {
                _variances[(y * side) + x] = At(x, y).Variance();
            }
        }

        for (int y = 0; y < _height; y++)
        {
            for (int x = 0; x < _width; x++)
            {
                double own = _variances[(y * side) + x];
                _spread[(y * side) + x] = (own + Around(x, y, own)) / 2;
            }
        }
    }

    /// <summary>The mean of the neighbours' variances; of a pixel without neighbours its own.</summary>
    private double Around(int x, int y, double own)
    {
        int left = Math.Max(0, x - 1), right = Math.Min(_width - 1, x + 1), top = Math.Max(0, y - 1), bottom = Math.Min(_height - 1, y + 1);
        double sum = -own;
        for (int row = top; row <= bottom; row++)
        {
            for (int column = left; column <= right; column++)
            {
                sum += _variances[(row * side) + column];
            }
        }

        int neighbours = ((right - left + 1) * (bottom - top + 1)) - 1;
        return neighbours == 0 ? own : Math.Max(0, sum) / neighbours;
    }

    private double ErrorOf(in Entry pixel, double spread)
    {
        double independent = spread / pixel.Count;
        if (pixel.Count == _firstSamples)
        {
            return gain * gain * _evenness * independent;
        }

        // Two halves may agree by chance; a straight edge through the pixel would leave this much.
        return gain * gain * Math.Max(pixel.Difference(), independent / (4 * Math.Sqrt(pixel.Count)));
    }

    private double Sum(Func<Entry, double> number)
    {
        double sum = 0;
        for (int y = 0; y < _height; y++)
        {
            for (int x = 0; x < _width; x++)
            {
                sum += number(At(x, y));
            }
        }

        return sum;
    }

    private static double Square(Intensity light) => ((double)light.R * light.R) + ((double)light.G * light.G) + ((double)light.B * light.B);

    private ref Entry At(int x, int y) => ref _pixels[(y * side) + x];

    private struct Entry
    {
        public Intensity Sum, Signed, Half, Whole;
        public double Squares;
        public int Count, Negative;

        /// <summary>Variance of the samples, the mean of the components; 0 where it is no number, so that such a pixel draws no samples.</summary>
        public readonly double Variance() => Finite((Squares - (Square(Sum) / Count)) / (3.0 * (Count - 1)));

        /// <summary>A quarter of the squared difference of the means of the first and the second half, the mean of the components.</summary>
        public readonly double Difference() => Finite(Square((Half * 2) - Whole) / (3.0 * Count * Count));

        private static double Finite(double value) => double.IsFinite(value) ? Math.Max(0, value) : 0;
    }
}
