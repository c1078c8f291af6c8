namespace LabRaytracer;

/// <content>Pixels whose samples are not the same for all: an error budget, or samples that count negatively.</content>
internal sealed unsafe partial class TileWorker<R, F, I>
{
    private readonly SamplePlaces _places;
    private readonly PixelEstimates? _estimates;
    private readonly PixelSlot[] _slots = [];
    private readonly List<(int X, int Y)> _chosen = [];
    private readonly int[] _chosenCounts = new int[Pixels];
    private int _slotCount;

    /// <summary>Samples every pixel, then those with the largest errors again, until the tile's error meets the budget.</summary>
    /// <returns>Sum of the pixels' estimated squared errors; 0 without a budget.</returns>
    private double SamplePixels(PixelEstimates estimates, int x, int y)
    {
        int width = Math.Min(Side, _area.X + _area.Width - x), height = Math.Min(Side, _area.Y + _area.Height - y);
        estimates.Start(width, height, _options.FirstSamples);
        for (int sample = 0; sample < _options.FirstSamples; sample++)
        {
            for (int i = 0; i < Pixels; i++)
            {
                (int px, int py) = Place(i);
                if (px < width && py < height)
                {
                    AddSlot(estimates, x, y, new PixelSlot(px, py, sample), _options.FirstSamples);
                }
            }
        }

        TraceSlots(estimates, x, y, _options.FirstSamples);
        double error = _options.HasBudget ? Refine(estimates, x, y, width * height) : 0;
        for (int row = 0; row < height; row++)
        {
            for (int column = 0; column < width; column++)
            {
                _colors.SetSum(Number(column, row), estimates.Mean(column, row));
                Counters.PrimaryRays += estimates.Count(column, row);
            }
        }

        return error;
    }

    /// <summary>Doubles the samples of the pixels that need it most, again and again.</summary>
    private double Refine(PixelEstimates estimates, int x, int y, int pixels)
    {
        double allowed = _options.ErrorBudget * _options.ErrorBudget * pixels, error = estimates.SquaredError();
        while (error > allowed)
        {
            estimates.Choose(_options.MaxSamples, _chosen);
            if (_chosen.Count == 0)
            {
                break;
            }

            foreach ((int px, int py) in _chosen)
            {
                _chosenCounts[(py * Side) + px] = estimates.Count(px, py);
            }

            for (int count = _options.FirstSamples; 2 * count <= _options.MaxSamples; count *= 2)
            {
                Double(estimates, x, y, count);
            }

            error = estimates.SquaredError();
        }

        return error;
    }

    /// <summary>Doubles the samples of those chosen pixels that have a certain number; the footprints of the new ones are smaller, as there are more.</summary>
    private void Double(PixelEstimates estimates, int x, int y, int count)
    {
        foreach ((int px, int py) in _chosen)
        {
            for (int sample = count; sample < 2 * count && _chosenCounts[(py * Side) + px] == count; sample++)
            {
                AddSlot(estimates, x, y, new PixelSlot(px, py, sample), 2 * count);
            }
        }

        TraceSlots(estimates, x, y, 2 * count);
    }

    private void AddSlot(PixelEstimates estimates, int x, int y, PixelSlot slot, int samples)
    {
        _slots[_slotCount++] = slot;
        if (_slotCount == Pixels)
        {
            TraceSlots(estimates, x, y, samples);
        }
    }

    /// <summary>Traces the samples that have been collected.</summary>
    /// <param name="estimates">Receives their light.</param>
    /// <param name="x">Column of the tile.</param>
    /// <param name="y">Row of the tile.</param>
    /// <param name="samples">Samples that their pixels are about to have.</param>
    private void TraceSlots(PixelEstimates estimates, int x, int y, int samples)
    {
        for (int i = 0; i < _slotCount; i++)
        {
            PixelSlot slot = _slots[i];
            double atX = _places.At(x + slot.X, y + slot.Y, slot.Sample, 0), atY = _places.At(x + slot.X, y + slot.Y, slot.Sample, 1);
            _slots[i].IsNegative = _places.Warp.IsNegative(atX, atY);
            _sampling?.Start(i, x + slot.X, y + slot.Y, slot.Sample);
            R.Put(_sampleX, i, x + slot.X + atX);
            R.Put(_sampleY, i, y + slot.Y + atY);
            R.Put(_rays.Limit, i, double.PositiveInfinity);
        }

        _grid = null;
        _sampling?.StartSample(0);
        _rays.Count = _slotCount;
        if (_slotCount > 0)
        {
            AimCamera(samples);
            _rays.PadTail();
            Counters.Charge(RenderStage.Camera);
            TracePrimary();
            TraceSecondary();
        }

        for (int i = 0; i < _slotCount; i++)
        {
            estimates.Add(_slots[i].X, _slots[i].Y, _colors.TakeSample(i), _slots[i].IsNegative);
        }

        _slotCount = 0;
    }

    /// <summary>A sample on its way: a pixel of the tile and the number of its sample.</summary>
    private struct PixelSlot(int x, int y, int sample)
    {
        public readonly int X = x, Y = y, Sample = sample;

        public bool IsNegative;
    }
}
