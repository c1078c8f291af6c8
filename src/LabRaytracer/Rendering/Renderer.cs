using System.Diagnostics;

namespace LabRaytracer;

/// <summary>Renders scenes: <c>Parallel.For</c> over tiles of the picture.</summary>
/// <remarks>
/// Thread safe as long as the scene is not edited. Pixels are the same to the last bit for any number of threads, any vector width and any processor.
/// </remarks>
public static class Renderer
{
    /// <summary>Renders a scene.</summary>
    /// <param name="scene">The scene; not edited meanwhile.</param>
    /// <param name="options">How; null for the defaults (1280 x 720, 1 sample a pixel).</param>
    /// <param name="progress">Told the finished share, (0, 1], now and then, from any thread; may be null.</param>
    /// <param name="cancellation">Stops the render between two tiles.</param>
    /// <returns>The picture, linear, and what was done.</returns>
    /// <exception cref="OperationCanceledException">The render was cancelled.</exception>
    /// <exception cref="ArgumentOutOfRangeException">The crop lies outside the picture.</exception>
    /// <exception cref="PictureFormatException">A texture's file is not a picture.</exception>
    public static RenderResult Render(
        Scene scene, RenderOptions? options = null, IProgress<double>? progress = null, CancellationToken cancellation = default) =>
        Render(scene, options ?? new RenderOptions(), LaneWidth.Best, progress, cancellation);

    /// <summary>Renders with a given vector width: the picture is the same, the time is not.</summary>
    internal static RenderResult Render(Scene scene, RenderOptions options, int laneWidth, IProgress<double>? progress, CancellationToken cancellation)
    {
        ArgumentNullException.ThrowIfNull(scene);
        PixelRectangle area = Area(options);
        cancellation.ThrowIfCancellationRequested();
        Picture picture = new(area.Width, area.Height);
        return new RenderResult(picture, Render(scene, options, laneWidth, new WholeTarget(picture, area.Y), progress, cancellation));
    }

    /// <summary>Renders and hands over finished bands of rows from the top: memory does not grow with the height of the picture.</summary>
    /// <param name="scene">The scene; not edited meanwhile.</param>
    /// <param name="options">How.</param>
    /// <param name="sink">Gets the bands.</param>
    /// <param name="progress">As for a whole picture.</param>
    /// <param name="cancellation">Stops the render between two tiles.</param>
    internal static RenderStatistics Render(
        Scene scene, RenderOptions options, IBandSink sink, IProgress<double>? progress = null, CancellationToken cancellation = default) =>
        Render(scene, options, LaneWidth.Best, new BandTarget(Area(options), sink, options.Threads), progress, cancellation);

    /// <summary>The part of the picture that is rendered.</summary>
    /// <exception cref="ArgumentOutOfRangeException">The crop lies outside the picture.</exception>
    internal static PixelRectangle Area(RenderOptions options)
    {
        PixelRectangle whole = new(0, 0, options.Width, options.Height);
        if (options.Crop is not { } crop)
        {
            return whole;
        }

        bool isInside = crop.X >= 0 && crop.Y >= 0 && crop.Width >= 1 && crop.Height >= 1
            && crop.X <= options.Width - crop.Width && crop.Y <= options.Height - crop.Height;
        return isInside
            ? crop
            : throw new ArgumentOutOfRangeException(nameof(options), crop, $"The crop must lie inside the picture of {options.Width} x {options.Height} pixels.");
    }

    private static RenderStatistics Render(
        Scene scene, RenderOptions options, int laneWidth, ITileTarget target, IProgress<double>? progress, CancellationToken cancellation) =>
        (options.Precision, laneWidth) switch
        {
            (Precision.Single, 16) => Render<Float16, Float16, Int16>(scene, options, target, progress, cancellation),
            (Precision.Single, 8) => Render<Float8, Float8, Int8>(scene, options, target, progress, cancellation),
            (Precision.Single, 4) => Render<Float4, Float4, Int4>(scene, options, target, progress, cancellation),
            (Precision.Single, _) => Render<Float1, Float1, Int1>(scene, options, target, progress, cancellation),
            (_, 16) => Render<Double16, Float16, Int16>(scene, options, target, progress, cancellation),
            (_, 8) => Render<Double8, Float8, Int8>(scene, options, target, progress, cancellation),
            (_, 4) => Render<Double4, Float4, Int4>(scene, options, target, progress, cancellation),
            _ => Render<Double1, Float1, Int1>(scene, options, target, progress, cancellation),
        };

    private static RenderStatistics Render<R, F, I>(
        Scene scene, RenderOptions options, ITileTarget target, IProgress<double>? progress, CancellationToken cancellation)
        where R : unmanaged, ILane<R, F, I>
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I>
    {
        cancellation.ThrowIfCancellationRequested();
        long start = Stopwatch.GetTimestamp();
        using CompiledScene<R, F, I> compiled = new(scene, options.Filter, options.Threads);
        EnvironmentTabulation<R, F, I>.Run(compiled, options.Threads);
        RenderStatistics statistics = new()
        {
            PrepareSeconds = Stopwatch.GetElapsedTime(start).TotalSeconds,
            Textures = compiled.Textures.Count,
            GeometryBytes = compiled.Bytes,
            LaneWidth = R.Width,
        };
        start = Stopwatch.GetTimestamp();
        new TileLoop<R, F, I>(compiled, options, Area(options), progress, cancellation).Run(target, statistics);
        statistics.RenderSeconds = Stopwatch.GetElapsedTime(start).TotalSeconds;
        GC.KeepAlive(scene);
        return statistics;
    }
}
