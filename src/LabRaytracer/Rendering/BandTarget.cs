namespace LabRaytracer;

/// <summary>A picture that is handed over in bands, from the top, each by the thread that finishes it; only a few bands are held.</summary>
/// <remarks>
/// A thread that runs ahead waits for the oldest band. That one always makes progress: its tiles were all taken before, by threads that do not wait.
/// </remarks>
internal sealed class BandTarget : ITileTarget
{
    private const int TileSide = PngRowWriter.RowStep;

    private readonly PixelRectangle _area;
    private readonly IBandSink _sink;
    private readonly int _columns;
    private readonly Band[] _bands;
    private readonly object _gate = new();
    private int _handedOver;
    private bool _stopped;

    /// <param name="area">The part of the picture that is rendered.</param>
    /// <param name="sink">Gets the bands.</param>
    /// <param name="threads">Threads that render.</param>
    public BandTarget(PixelRectangle area, IBandSink sink, int threads)
    {
        _area = area;
        _sink = sink;
        _columns = (area.Width + TileSide - 1) / TileSide;
        int all = (area.Height + sink.BandRows - 1) / sink.BandRows;

        // One being rendered and one being compressed for each thread, and one that waits for its turn.
        _bands = new Band[(int)Math.Min(all, (2L * threads) + 1)];
    }

    /// <inheritdoc/>
    public PicturePart? Open(int tileRow)
    {
        int number = tileRow * TileSide / _sink.BandRows;
        lock (_gate)
        {
            while (!_stopped && number >= _handedOver + _bands.Length)
            {
                Monitor.Wait(_gate);
            }

            return _stopped ? null : new PicturePart(BandOf(number).Pixels, TopOf(number));
        }
    }

    /// <inheritdoc/>
    public void Close(int tileRow)
    {
        int number = tileRow * TileSide / _sink.BandRows;
        Band band;
        lock (_gate)
        {
            band = _bands[number % _bands.Length];
            if (--band.OpenTiles > 0)
            {
                return;
            }
        }

        Action handOver = _sink.Prepare(band.Pixels.Pixels[..(RowsOf(number) * _area.Width)]);
        lock (_gate)
        {
            band.HandOver = handOver;
            HandOverInOrder();
            Monitor.PulseAll(_gate);
        }
    }

    /// <inheritdoc/>
    public void Stop()
    {
        lock (_gate)
        {
            _stopped = true;
            Monitor.PulseAll(_gate);
        }
    }

    private void HandOverInOrder()
    {
        while (_bands[_handedOver % _bands.Length] is { HandOver: { } handOver } band && !_stopped)
        {
            handOver();
            band.HandOver = null;
            _handedOver++;
        }
    }

    private int TopOf(int number) => _area.Y + (number * _sink.BandRows);

    private int RowsOf(int number) => Math.Min(_sink.BandRows, _area.Height - (number * _sink.BandRows));

    /// <summary>The band of this number; its memory was that of an older one.</summary>
    private Band BandOf(int number)
    {
        Band band = _bands[number % _bands.Length] ??= new Band(new Picture(_area.Width, Math.Min(_sink.BandRows, _area.Height)));
        if (band.Number != number)
        {
            band.Number = number;
            band.OpenTiles = _columns * ((RowsOf(number) + TileSide - 1) / TileSide);
        }

        return band;
    }

    private sealed class Band(Picture pixels)
    {
        public Picture Pixels { get; } = pixels;

        public int Number { get; set; } = -1;

        public int OpenTiles { get; set; }

        public Action? HandOver { get; set; }
    }
}
