namespace LabRaytracer;

/// <summary>Spreads the tiles of a picture over threads.</summary>
internal sealed class TileLoop<R, F, I>(
    CompiledScene<R, F, I> scene, RenderOptions options, PixelRectangle area, IProgress<double>? progress, CancellationToken cancellation)
    where R : unmanaged, ILane<R, F, I>
    where F : unmanaged, ILane<F, F, I>
    where I : unmanaged, IIndexLane<I>
{
    private readonly int _columns = (area.Width + TileWorker<R, F, I>.Side - 1) / TileWorker<R, F, I>.Side;
    private readonly int _rows = (area.Height + TileWorker<R, F, I>.Side - 1) / TileWorker<R, F, I>.Side;
    private readonly Lock _lock = new();
    private double[] _squaredErrors = [];
    private int _next;
    private int _finished;

    /// <summary>Renders all tiles into a target and adds up the workers' counts.</summary>
    public void Run(ITileTarget target, RenderStatistics statistics)
    {
        double[] stageSeconds = new double[Enum.GetValues<RenderStage>().Length];
        _squaredErrors = new double[options.HasBudget ? _columns * _rows : 0];
        int workers = Math.Min(options.Threads, _columns * _rows);
        if (workers == 1)
        {
            Work(target, statistics, stageSeconds);
        }
        else
        {
            RunParallel(workers, () => Work(target, statistics, stageSeconds));
        }

        if (options.HasBudget)
        {
            // Tiles are added in their order: the sum does not depend on threads.
            statistics.EstimatedRmse = Math.Sqrt(_squaredErrors.Aggregate(0.0, (sum, error) => sum + error) / ((double)area.Width * area.Height));
        }

        statistics.StageSeconds = Enum.GetValues<RenderStage>().ToDictionary(stage => stage.ToString(), stage => stageSeconds[(int)stage]);
    }

    private void RunParallel(int workers, Action work)
    {
        try
        {
            Parallel.For(0, workers, new ParallelOptions { MaxDegreeOfParallelism = workers, CancellationToken = cancellation }, _ => work());
        }
        catch (AggregateException failure)
        {
            throw failure.Flatten().InnerExceptions[0];
        }
    }

    /// <summary>One worker: takes the next tile until none is left.</summary>
    private void Work(ITileTarget target, RenderStatistics statistics, double[] stageSeconds)
    {
        using TileWorker<R, F, I> worker = new(scene, options, area);
        try
        {
            for (int tile = Interlocked.Increment(ref _next) - 1; tile < _columns * _rows; tile = Interlocked.Increment(ref _next) - 1)
            {
                cancellation.ThrowIfCancellationRequested();
                if (target.Open(tile / _columns) is not { } part)
                {
                    return;
                }

                Render(worker, tile, part);
                target.Close(tile / _columns);
            }
        }
        catch
        {
            target.Stop();
            throw;
        }

        lock (_lock)
        {
            worker.Counters.AddTo(statistics, stageSeconds);
        }
    }

    private void Render(TileWorker<R, F, I> worker, int tile, PicturePart part)
    {
        int x = area.X + ((tile % _columns) * TileWorker<R, F, I>.Side), y = area.Y + ((tile / _columns) * TileWorker<R, F, I>.Side);
        try
        {
            double squaredError = worker.Render(x, y, part.Pixels, part.Top);
            if (options.HasBudget)
            {
                _squaredErrors[tile] = squaredError;
            }
        }
        catch (Exception cause)
        {
            throw new RenderException($"Rendering failed in the tile whose top-left pixel is ({x}, {y}): {cause.Message}", cause);
        }

        progress?.Report((double)Interlocked.Increment(ref _finished) / (_columns * _rows));
    }
}
