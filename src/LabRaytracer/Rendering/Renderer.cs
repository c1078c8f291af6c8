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

    /// <summary>Renders into a picture that is there already: frame after frame, without new memory for each.</summary>
    /// <param name="scene">The scene; not edited meanwhile.</param>
    /// <param name="options">How; its crop, or else its whole size, is that of the picture.</param>
    /// <param name="into">Receives the pixels, linear; what it showed is lost, also if the render is cancelled or fails.</param>
    /// <param name="progress">As for <see cref="Render(Scene, RenderOptions?, IProgress{double}?, CancellationToken)"/>.</param>
    /// <param name="cancellation">Stops the render between two tiles.</param>
    /// <returns>What was done.</returns>
    /// <exception cref="ArgumentException">The picture has another size.</exception>
    /// <exception cref="OperationCanceledException">The render was cancelled.</exception>
    /// <exception cref="ArgumentOutOfRangeException">The crop lies outside the picture of the options.</exception>
    /// <exception cref="PictureFormatException">A texture's file is not a picture.</exception>
    public static RenderStatistics RenderInto(
        Scene scene, RenderOptions options, Picture into, IProgress<double>? progress = null, CancellationToken cancellation = default)
    {
        ArgumentNullException.ThrowIfNull(scene);
        ArgumentNullException.ThrowIfNull(options);
        ArgumentNullException.ThrowIfNull(into);
        PixelRectangle area = Area(options);
        if (into.Width != area.Width || into.Height != area.Height)
        {
            throw new ArgumentException(
                $"The picture has {into.Width} x {into.Height} pixels; the options say {area.Width} x {area.Height}.", nameof(into));
        }

        if (TileArea(options) == area)
        {
            return Render(scene, options, LaneWidth.Best, area, new WholeTarget(into, area.Y), progress, cancellation);
        }

        (Picture picture, RenderStatistics statistics) = Render(scene, options, LaneWidth.Best, progress, cancellation);
        picture.Pixels.CopyTo(into.Pixels);
        return statistics;
    }

    /// <summary>Renders with a given vector width: the picture is the same, the time is not.</summary>
    internal static RenderResult Render(Scene scene, RenderOptions options, int laneWidth, IProgress<double>? progress, CancellationToken cancellation)
    {
        ArgumentNullException.ThrowIfNull(scene);
        PixelRectangle area = Area(options), tiles = TileArea(options);
        cancellation.ThrowIfCancellationRequested();
        Picture picture = Picture.Unwritten(tiles.Width, tiles.Height);
        RenderStatistics statistics = Render(scene, options, laneWidth, tiles, new WholeTarget(picture, tiles.Y), progress, cancellation);
        return new RenderResult(tiles == area ? picture : Cut(picture, tiles, area), statistics);
    }

    /// <summary>Renders and hands over finished bands of rows from the top: memory does not grow with the height of the picture.</summary>
    /// <param name="scene">The scene; not edited meanwhile.</param>
    /// <param name="options">How.</param>
    /// <param name="sink">Gets the bands.</param>
    /// <param name="progress">As for a whole picture.</param>
    /// <param name="cancellation">Stops the render between two tiles.</param>
    internal static RenderStatistics Render(
        Scene scene, RenderOptions options, IBandSink sink, IProgress<double>? progress = null, CancellationToken cancellation = default)
    {
        PixelRectangle area = Area(options);
        if (TileArea(options) == area)
        {
            return Render(scene, options, LaneWidth.Best, area, new BandTarget(area, sink, options.Threads), progress, cancellation);
        }

        (Picture picture, RenderStatistics statistics) = Render(scene, options, LaneWidth.Best, progress, cancellation);
        for (int row = 0; row < area.Height; row += sink.BandRows)
        {
            sink.Prepare(picture.Pixels.Slice(row * area.Width, Math.Min(sink.BandRows, area.Height - row) * area.Width))();
        }

        return statistics;
    }

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

    /// <summary>The part of the picture that is rendered in tiles: under an error budget, which tiles share out, whole tiles of the whole picture, so that a crop has the same pixels.</summary>
    private static PixelRectangle TileArea(RenderOptions options)
    {
        PixelRectangle area = Area(options);
        if (!options.HasBudget)
        {
            return area;
        }

        const int Side = PngRowWriter.RowStep;
        int left = area.X / Side * Side, top = area.Y / Side * Side;
        int right = Math.Min(options.Width, (area.X + area.Width + Side - 1) / Side * Side);
        int bottom = Math.Min(options.Height, (area.Y + area.Height + Side - 1) / Side * Side);
        return new PixelRectangle(left, top, right - left, bottom - top);
    }

    private static Picture Cut(Picture picture, PixelRectangle from, PixelRectangle area)
    {
        Picture part = new(area.Width, area.Height);
        for (int row = 0; row < area.Height; row++)
        {
            picture.Row(area.Y - from.Y + row).Slice(area.X - from.X, area.Width).CopyTo(part.Row(row));
        }

        return part;
    }

    private static RenderStatistics Render(
        Scene scene, RenderOptions options, int laneWidth, PixelRectangle area, ITileTarget target, IProgress<double>? progress, CancellationToken cancellation) =>
        (options.Precision, laneWidth) switch
        {
            (Precision.Single, 16) => Render<Float16, Float16, Int16>(scene, options, area, target, progress, cancellation),
            (Precision.Single, 8) => Render<Float8, Float8, Int8>(scene, options, area, target, progress, cancellation),
            (Precision.Single, 4) => Render<Float4, Float4, Int4>(scene, options, area, target, progress, cancellation),
            (Precision.Single, _) => Render<Float1, Float1, Int1>(scene, options, area, target, progress, cancellation),
            (_, 16) => Render<Double16, Float16, Int16>(scene, options, area, target, progress, cancellation),
            (_, 8) => Render<Double8, Float8, Int8>(scene, options, area, target, progress, cancellation),
            (_, 4) => Render<Double4, Float4, Int4>(scene, options, area, target, progress, cancellation),
            _ => Render<Double1, Float1, Int1>(scene, options, area, target, progress, cancellation),
        };

    private static RenderStatistics Render<R, F, I>(
        Scene scene, RenderOptions options, PixelRectangle area, ITileTarget target, IProgress<double>? progress, CancellationToken cancellation)
        where R : unmanaged, ILane<R, F, I>
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I>
    {
        cancellation.ThrowIfCancellationRequested();
        long start = Stopwatch.GetTimestamp();
        using CompiledScene<R, F, I> compiled = new(scene, options.Filter, options.Threads, options.IsSkipping);
        EnvironmentTabulation<R, F, I>.Run(compiled, options.Threads);
        RenderStatistics statistics = new()
        {
            PrepareSeconds = Stopwatch.GetElapsedTime(start).TotalSeconds,
            Textures = compiled.Textures.Count,
            TexturesSkipped = compiled.TexturesSkipped,
            GeometryBytes = compiled.Bytes,
            LaneWidth = R.Width,
        };
        start = Stopwatch.GetTimestamp();
        new TileLoop<R, F, I>(compiled, options, area, progress, cancellation).Run(target, statistics);
        statistics.RenderSeconds = Stopwatch.GetElapsedTime(start).TotalSeconds;
        statistics.FilterFallbacks = compiled.Textures.Fallbacks;
        GC.KeepAlive(scene);
        return statistics;
    }
}
