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
        SlotRun run = new(estimates, _places, x, y, _options.FirstSamples);
        estimates.Start(width, height, _options.FirstSamples);
        for (int sample = 0; sample < _options.FirstSamples; sample++)
        {
            for (int i = 0; i < Pixels; i++)
            {
                (int px, int py) = Place(i);
                if (px < width && py < height)
                {
                    AddSlot(run, new PixelSlot(px, py, sample));
                }
            }
        }

        TraceSlots(run);
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
        SlotRun run = new(estimates, _places, x, y, 2 * count);
        foreach ((int px, int py) in _chosen)
        {
            for (int sample = count; sample < 2 * count && _chosenCounts[(py * Side) + px] == count; sample++)
            {
                AddSlot(run, new PixelSlot(px, py, sample));
            }
        }

        TraceSlots(run);
    }

    private void AddSlot(in SlotRun run, PixelSlot slot)
    {
        _slots[_slotCount++] = slot;
        if (_slotCount == Pixels)
        {
            TraceSlots(run);
        }
    }

    /// <summary>Traces the samples that have been collected.</summary>
    private void TraceSlots(in SlotRun run)
    {
        for (int i = 0; i < _slotCount; i++)
        {
            PixelSlot slot = _slots[i];
            int x = run.X + slot.X, y = run.Y + slot.Y;
            double atX = run.Places.At(x, y, slot.Sample, 0), atY = run.Places.At(x, y, slot.Sample, 1);
            _slots[i].IsNegative = run.Places.Warp.IsNegative(atX, atY);
            _sampling?.Start(i, x, y, slot.Sample);
            R.Put(_sampleX, i, x + atX);
            R.Put(_sampleY, i, y + atY);
            R.Put(_rays.Limit, i, double.PositiveInfinity);
        }

        _grid = null;
        _sampling?.StartSample(0);
        _rays.Count = _slotCount;
        if (_slotCount > 0)
        {
            AimCamera(run.Samples);
            _rays.PadTail();
            _originPackets = 0;
            Counters.Charge(RenderStage.Camera);
            TracePrimary();
            TraceSecondary();
        }

        for (int i = 0; i < _slotCount; i++)
        {
            run.Sums.Add(_slots[i].X, _slots[i].Y, _colors.TakeSample(i), _slots[i].IsNegative);
        }

        _slotCount = 0;
    }

    /// <summary>Where the light of samples goes.</summary>
    /// <param name="Sums">Sums it up.</param>
    /// <param name="Places">Where in their pixels the samples lie.</param>
    /// <param name="X">Column of the tile.</param>
    /// <param name="Y">Row of the tile.</param>
    /// <param name="Samples">Samples that the pixels are about to have.</param>
    private readonly record struct SlotRun(PixelEstimates Sums, SamplePlaces Places, int X, int Y, int Samples);

    /// <summary>A sample on its way: a pixel of the tile and the number of its sample.</summary>
    private struct PixelSlot(int x, int y, int sample)
    {
        public readonly int X = x, Y = y, Sample = sample;

        public bool IsNegative;
    }
}
