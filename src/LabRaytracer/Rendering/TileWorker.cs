namespace LabRaytracer;

/// <summary>Renders tiles, one after the other; owned by one thread.</summary>
internal sealed unsafe partial class TileWorker<R, F, I> : IDisposable
    where R : unmanaged, ILane<R, F, I>
    where F : unmanaged, ILane<F, F, I>
    where I : unmanaged, IIndexLane<I>
{
    /// <summary>Width and height of a tile, pixels.</summary>
    public const int Side = 32;

    private const int Block = 4;
    private const int Pixels = Side * Side;

    private readonly CompiledScene<R, F, I> _scene;
    private readonly RenderOptions _options;
    private readonly PixelRectangle _area;
    private readonly LaneMemory _memory = new();
    private readonly BatchTracer<R, F, I> _tracer;
    private readonly RayBatch<R, F, I> _rays;
    private readonly R* _pixelX;
    private readonly R* _pixelY;
    private readonly R* _sampleX;
    private readonly R* _sampleY;
    private readonly ulong* _pixelNumbers;
    private readonly double* _samplePlaces;
    private readonly TileColors<F> _colors;
    private readonly SeamMarks? _seams;
    private readonly PixelSampling? _sampling;
    private readonly LensStage<R, F, I>? _lens;
    private bool _hasPrimaryOrder;
    private SecondaryQueue<R, F, I> _queue;
    private SecondaryQueue<R, F, I> _next;

    /// <param name="scene">The scene.</param>
    /// <param name="options">How it is rendered.</param>
    /// <param name="area">The part of the picture that is rendered.</param>
    public TileWorker(CompiledScene<R, F, I> scene, RenderOptions options, PixelRectangle area)
    {
        _scene = scene;
        _options = options;
        _area = area;
        _sampling = scene.NeedsSampling ? new PixelSampling(options.Seed, Pixels) : null;
        _tracer = new BatchTracer<R, F, I>(scene, options, _memory, new WorkerCounters(), Pixels, _sampling);
        _rays = new RayBatch<R, F, I>(_memory, Pixels, _tracer.HasDifferentials);
        _queue = new SecondaryQueue<R, F, I>(_memory, _tracer.HasDifferentials);
        _next = new SecondaryQueue<R, F, I>(_memory, _tracer.HasDifferentials);
        _pixelX = _memory.Column<R>(Pixels, R.Width);
        _pixelY = _memory.Column<R>(Pixels, R.Width);
        _sampleX = _memory.Column<R>(Pixels, R.Width);
        _sampleY = _memory.Column<R>(Pixels, R.Width);
        _pixelNumbers = _memory.Column<ulong>(Pixels, 1);
        _samplePlaces = _memory.Column<double>(Pixels, 1);
        _colors = new TileColors<F>(_memory, Pixels);
        _places = new SamplePlaces(options);
        if (ViewStage.IsColor(options.View) && (options.HasBudget || _places.Warp.IsSigned))
        {
            _estimates = new PixelEstimates(Side, _places.Warp.Gain);
        }

        if (options.HasEdges)
        {
            _edges = new EdgeMarks(Side, _places.Warp.Reach);
            _edgeSums = new PixelEstimates(Side, _places.Warp.Gain);
            _edgePlaces = new SamplePlaces(options, SamplePattern.Sobol);
        }

        _slots = _estimates is null && _edges is null ? [] : new PixelSlot[Pixels];

        _lens = scene.Camera.HasLens && options.View != RenderView.Seam ? new LensStage<R, F, I>(scene.Camera, _sampling!, _memory, Pixels) : null;
        _seams = options.View == RenderView.Seam ? new SeamMarks(Pixels) : null;
        for (int i = 0; i < Pixels; i++)
        {
            (int x, int y) = Place(i);
            R.Put(_pixelX, i, x);
            R.Put(_pixelY, i, y);
            _pixelNumbers[i] = ((ulong)(uint)x << 32) | (uint)y;
        }

        FindRectangles();
    }

    /// <summary>Counts and times of this worker.</summary>
    public WorkerCounters Counters => _tracer.Counters;

    /// <summary>Renders the tile whose top-left pixel is (x, y) of the whole picture.</summary>
    /// <param name="x">Column.</param>
    /// <param name="y">Row.</param>
    /// <param name="picture">Gets the pixels; as wide as the rendered part.</param>
    /// <param name="top">Row of the whole picture that is its row 0.</param>
    /// <returns>Sum of the pixels' estimated squared errors; 0 without an error budget.</returns>
    public double Render(int x, int y, Picture picture, int top)
    {
        Counters.Start();
        double error = 0;
        if (_estimates is { } estimates)
        {
            error = SamplePixels(estimates, x, y);
        }
        else
        {
            SampleAlike(x, y);
        }

        if (_edges is { } edges)
        {
            SampleEdges(edges, _edgeSums!, x, y);
        }

        FindSeams(x, y);
        Write(x, y, picture, top);
        Counters.Charge(RenderStage.Combine);
        return error;
    }

    public void Dispose() => _memory.Dispose();

    /// <summary>The same number of samples in all pixels.</summary>
    private void SampleAlike(int x, int y)
    {
        _tracer.Tally?.Clear();
        _sampling?.StartTile(x, y, Place);
        for (int sample = 0; sample < _options.Samples; sample++)
        {
            _sampling?.StartSample(sample);
            Aim(x, y, sample);
            Counters.Charge(RenderStage.Camera);
            TracePrimary();
            TraceSecondary();
            if (sample == 0)
            {
                _colors.StartSum();
            }
            else
            {
                _colors.AddToSum();
            }
        }

        _colors.Average(_options.Samples);
        int width = Math.Min(Side, _area.X + _area.Width - x), height = Math.Min(Side, _area.Y + _area.Height - y);
        Counters.PrimaryRays += (long)width * height * _options.Samples;
    }

    /// <summary>Position of pixel number i in its tile: blocks of 4 x 4, four of them in a block of 8 x 8 and so on, so that rays that are looked at together are neighbours in both directions.</summary>
    private static (int X, int Y) Place(int i)
    {
        int block = i / (Block * Block), inside = i % (Block * Block);
        return ((Gathered(block) * Block) + (inside % Block), (Gathered(block >> 1) * Block) + (inside / Block));
    }

    /// <summary>Number of the pixel at a position of its tile: the inverse of <see cref="Place"/>.</summary>
    private static int Number(int x, int y) =>
        ((((Scattered(x / Block) | (Scattered(y / Block) << 1)) * Block) + (y % Block)) * Block) + (x % Block);

    /// <summary>Bits 0, 2 and 4 of a number of at most six bits as a number.</summary>
    private static int Gathered(int number) => (number & 1) | ((number >> 1) & 2) | ((number >> 2) & 4);

    /// <summary>The three bits of a number as bits 0, 2 and 4.</summary>
    private static int Scattered(int number) => (number & 1) | ((number & 2) << 1) | ((number & 4) << 2);

    private void TracePrimary()
    {
        if (!_hasPrimaryOrder)
        {
            ColorColumns<F> weights = _tracer.Weights;
            for (int packet = 0; packet < Pixels / R.Width; packet++)
            {
                _tracer.Pixels[packet] = I.Iota(packet * R.Width);
                weights.R[packet] = weights.G[packet] = weights.B[packet] = F.Of(1);
            }

            _hasPrimaryOrder = true;
        }

        _queue.Clear();
        _tracer.Trace(_rays, 0, _queue);
        _tracer.Radiance = _colors.SetSample(_tracer.Radiance);
    }

    /// <summary>Level after level of reflection and refraction; each in batches, in the order in which they arose.</summary>
    private void TraceSecondary()
    {
        bool any = _queue.Count > 0;
        for (int depth = 1; _queue.Count > 0; depth++)
        {
            _next.Clear();
            for (int first = 0; first < _queue.Count; first += Pixels)
            {
                Load(first, Math.Min(Pixels, _queue.Count - first));
                _tracer.Trace(_rays, depth, _next);
                AddToSample();
            }

            (_queue, _next) = (_next, _queue);
        }

        if (any)
        {
            // Whoever uses the batch next has rays that leave no object.
            new Span<int>(_rays.Source, Pixels).Fill(-1);
        }
    }

    private void Load(int first, int count)
    {
        _rays.Count = count;
        _rays.Bounds = null;
        _rays.Pinhole = null;
        _hasPrimaryOrder = false;
        _originPackets = 0;
        _queue.Take(first, _rays, _tracer.Weights, _tracer.Pixels);
        _rays.PadTail();
    }

    /// <summary>Adds the light of secondary rays to their pixels: at once where a group of lanes has consecutive ones.</summary>
    private void AddToSample()
    {
        ColorColumns<F> light = _tracer.Radiance, weights = _tracer.Weights;
        I* pixels = _tracer.Pixels;
        for (int packet = 0; packet < _rays.Packets; packet++)
        {
            int first = packet * R.Width, pixel = ((int*)pixels)[first];
            if (_scene.IsSkipping && first + R.Width <= _rays.Count && I.AllEqual(pixels[packet] - I.Iota(0), pixel))
            {
                _colors.AddToSample(pixel, light.R[packet] * weights.R[packet], light.G[packet] * weights.G[packet], light.B[packet] * weights.B[packet]);
                continue;
            }

            for (int ray = first; ray < Math.Min(first + R.Width, _rays.Count); ray++)
            {
                // Light without weight counts for nothing, even where it is not finite.
                Intensity weight = weights.Take(ray);
                if (_scene.IsSkipping || weight != Intensity.Black)
                {
                    _colors.AddToSample(((int*)pixels)[ray], light.Take(ray) * weight);
                }
            }
        }
    }
}
