using System.Globalization;
using BenchmarkDotNet.Attributes;
using RenderScene;

namespace LabRaytracer.Benchmarks;

/// <summary>
/// Whole pictures of 320 x 180, one thread, by precision and samples a pixel. The column RMSE is the distance, in linear light, from the converged picture
/// (144 jittered samples of another seed): what is left is aliasing, and in double lanes nothing else.
/// </summary>
/// <remarks>The bench scenes, whose pictures are made first, have a command of their own: <c>-- scenes</c>.</remarks>
[Config(typeof(ErrorConfig<SceneBenchmarks>))]
public class SceneBenchmarks : IMeasuresErrors
{
    private Scene _scene = null!;
    private Picture? _picture;

    /// <summary>The scene: a file of scenes/ without its ending.</summary>
    [Params("06-earth", "09-reflection-refraction", "14-ewa")]
    public string Name { get; set; } = "06-earth";

    /// <summary>Samples a pixel.</summary>
    [Params(1, 16)]
    public int Samples { get; set; } = 1;

    /// <inheritdoc/>
    public static IReadOnlyList<string> ErrorNames => ["RMSE"];

    [GlobalSetup]
    public void Setup() => _scene = SceneFile.Load(Path.Combine(BenchPlan.Root, "scenes", Name + ".json")).Scene;

    [Benchmark(Baseline = true)]
    public void DoubleLanes() => _picture = Render(Precision.Double, Samples, 0);

    [Benchmark]
    public void FloatLanes() => _picture = Render(Precision.Single, Samples, 0);

    /// <inheritdoc/>
    public IReadOnlyList<string> Errors(string method)
    {
        ((Action)Delegate.CreateDelegate(typeof(Action), this, method))();
        double rmse = FrontierSweep.Rmse(_picture!, Render(Precision.Double, 144, 1));
        return [rmse.ToString("G3", CultureInfo.InvariantCulture)];
    }

    private Picture Render(Precision precision, int samples, int seed) => Renderer.Render(_scene, new RenderOptions
    {
        Width = 320, Height = 180, Precision = precision, Samples = samples, Seed = seed, Threads = 1,
        Pattern = samples == 1 ? SamplePattern.Regular : SamplePattern.Jittered,
    }).Picture;
}
