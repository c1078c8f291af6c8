namespace LabRaytracer;

/// <content>Pixels whose samples are not the same for all: an error budget, or samples that count negatively.</content>
internal sealed unsafe partial class TileWorker<R, F, I>
{
    private readonly SamplePlaces _places;
    private readonly PixelEstimates? _estimates;
    private readonly PixelSlot[] _slots = [];
    private readonly List<(int X, int Y)> _chosen = [];
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
                    AddSlot(estimates, x, y, new PixelSlot(px, py, sample));
                }
            }
        }

        TraceSlots(estimates, x, y);
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
                int count = estimates.Count(px, py);
                for (int sample = count; sample < 2 * count; sample++)
                {
                    AddSlot(estimates, x, y, new PixelSlot(px, py, sample));
                }
            }

            TraceSlots(estimates, x, y);
            error = estimates.SquaredError();
        }

        return error;
    }

    private void AddSlot(PixelEstimates estimates, int x, int y, PixelSlot slot)
    {
        _slots[_slotCount++] = slot;
        if (_slotCount == Pixels)
        {
            TraceSlots(estimates, x, y);
        }
    }

    /// <summary>Traces the samples that have been collected.</summary>
    private void TraceSlots(PixelEstimates estimates, int x, int y)
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

        _sampling?.StartSample(0);
        _rays.Count = _slotCount;
        if (_slotCount > 0)
        {
            AimCamera();
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
