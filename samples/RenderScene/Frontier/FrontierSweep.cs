using System.Globalization;
using LabRaytracer;

namespace RenderScene;

/// <summary>Renders a scene in many ways, on one thread, and compares each picture with the converged one.</summary>
/// <param name="scene">The scene.</param>
/// <param name="width">Width of the pictures, pixels.</param>
/// <param name="height">Height of the pictures, pixels.</param>
internal sealed class FrontierSweep(LoadedScene scene, int width, int height)
{
    private const int Repeats = 3;

    private static readonly int[] s_samples = [1, 4, 16, 64];

    private static readonly int[] s_edgeSamples = [16, 64];

    private static readonly double[] s_budgets = [0.05, 0.02, 0.01, 0.005];

    private InnerPixels? _inner;

    /// <summary>The converged picture, from a file if it is there and younger than the scene, else rendered and kept.</summary>
    /// <param name="samples">Samples a pixel, a square number.</param>
    /// <param name="scenePath">The scene file.</param>
    /// <param name="cacheFolder">Where converged pictures are kept.</param>
    /// <param name="stop">Stops it.</param>
    public Picture Converged(int samples, string scenePath, string cacheFolder, CancellationToken stop)
    {
        Directory.CreateDirectory(cacheFolder);
        string name = string.Create(CultureInfo.InvariantCulture, $"{Path.GetFileNameWithoutExtension(scenePath)}-{width}x{height}-{samples}.pfm");
        string path = Path.Combine(cacheFolder, name);
        if (File.Exists(path) && File.GetLastWriteTimeUtc(path) > File.GetLastWriteTimeUtc(scenePath))
        {
            return Picture.Load(path);
        }

        Picture converged = Renderer.Render(scene.Scene, Options(samples, Environment.ProcessorCount, seed: 1, pattern: SamplePattern.Sobol), cancellation: stop).Picture;
        converged.Save(path);
        return converged;
    }

    /// <summary>All ways: the scene's own filters, each filter, more samples at edges of objects, floats, error budgets.</summary>
    /// <param name="converged">What pictures are compared with.</param>
    /// <param name="say">Told each point.</param>
    /// <param name="stop">Stops it.</param>
    public List<FrontierPoint> Run(Picture converged, Action<FrontierPoint> say, CancellationToken stop)
    {
        List<FrontierPoint> points = [];
        foreach ((string series, string variant, RenderOptions options) in Ways())
        {
            stop.ThrowIfCancellationRequested();
            FrontierPoint point = Measure(series, variant, options, converged, stop);
            points.Add(point);
            say(point);
        }

        return points;
    }

    /// <summary>The pixels that no edge of an object crosses.</summary>
    public InnerPixels Inner => _inner ??= new InnerPixels(Renderer.Render(
        scene.Scene, new RenderOptions { Width = width, Height = height, View = RenderView.Object, Threads = 1 }).Picture);

    /// <summary>Root mean square error of linear light, over all pixels and components.</summary>
    public static double Rmse(Picture a, Picture b)
    {
        double sum = 0;
        for (int i = 0; i < a.Pixels.Length; i++)
        {
            sum += Square(a.Pixels[i] - b.Pixels[i]);
        }

        return Math.Sqrt(sum / (3.0 * a.Pixels.Length));
    }

    /// <summary>Sum of the squares of a difference's components.</summary>
    public static double Square(Intensity difference) =>
        ((double)difference.R * difference.R) + ((double)difference.G * difference.G) + ((double)difference.B * difference.B);

    private IEnumerable<(string Series, string Variant, RenderOptions Options)> Ways()
    {
        foreach (int samples in s_samples)
        {
            yield return ("own filters, regular", Samples(samples), Options(samples));
            yield return ("own filters, Sobol", Samples(samples), Options(samples, pattern: SamplePattern.Sobol));
        }

        foreach (TextureFilter filter in Enum.GetValues<TextureFilter>())
        {
            if (filter == TextureFilter.Area)
            {
                // The exact integral is what the others are measured with: a thousand times their time.
                continue;
            }

            // Footprints of regular samples tile the pixel; where textures are read at points, scattered samples are better.
            SamplePattern pattern = filter > TextureFilter.BSpline ? SamplePattern.Regular : SamplePattern.Sobol;
            foreach (int samples in s_samples)
            {
                yield return ($"all {filter}", Samples(samples), Options(samples, filter: filter, pattern: pattern));
            }
        }

        foreach (int samples in s_edgeSamples)
        {
            yield return ("all Ewa, more at edges", Samples(1) + string.Create(CultureInfo.InvariantCulture, $", {samples} at edges"), Options(1, filter: TextureFilter.Ewa, edgeSamples: samples));
        }

        foreach (int samples in s_samples)
        {
            yield return ("own, floats", Samples(samples), Options(samples, precision: Precision.Single));
        }

        foreach (double budget in s_budgets)
        {
            yield return ("own, budget", string.Create(CultureInfo.InvariantCulture, $"budget {budget}"), Options(1, budget: budget));
        }
    }

    private static string Samples(int samples) => string.Create(CultureInfo.InvariantCulture, $"{samples} sample{(samples == 1 ? "" : "s")}");

    private RenderOptions Options(
        int samples, int threads = 1, int seed = 0, TextureFilter? filter = null, SamplePattern pattern = SamplePattern.Regular, Precision precision = Precision.Double, double budget = 0,
        int edgeSamples = 1) => new()
        {
            Width = width,
            Height = height,
            Samples = samples,
            Threads = threads,
            Seed = seed,
            Filter = filter,
            Precision = precision,
            ErrorBudget = budget,
            EdgeSamples = edgeSamples,
            Pattern = samples == 1 ? SamplePattern.Regular : pattern,
            PixelFilter = scene.RenderOptions.PixelFilter,
            MaxDepth = scene.RenderOptions.MaxDepth,
        };

    /// <summary>The shortest of a few renders: the first one compiles code.</summary>
    private FrontierPoint Measure(string series, string variant, RenderOptions options, Picture converged, CancellationToken stop)
    {
        double seconds = double.PositiveInfinity, rmse = 0, innerRmse = 0;
        for (int repeat = 0; repeat < Repeats; repeat++)
        {
            RenderResult result = Renderer.Render(scene.Scene, options, cancellation: stop);
            seconds = Math.Min(seconds, result.Statistics.RenderSeconds);
            rmse = Rmse(result.Picture, converged);
            innerRmse = Inner.Rmse(result.Picture, converged);
        }

        return new FrontierPoint(series, variant, seconds, rmse, innerRmse);
    }
}
