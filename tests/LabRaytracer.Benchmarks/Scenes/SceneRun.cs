using System.Diagnostics;

namespace LabRaytracer.Benchmarks;

/// <summary>Measures the scenes s1 to s5, time against error, and the sweeps; contenders take turns, so that a busy machine is unfair to none.</summary>
internal sealed class SceneRun
{
    /// <summary>Name of this program in results.</summary>
    public const string Ours = "LabRaytracer";

    /// <summary>Name of the other program in results.</summary>
    public const string Pov = "POV-Ray";

    private static readonly string[] s_scenes = ["s1", "s2", "s3", "s4", "s5"];

    private readonly BenchPlan _plan;
    private readonly Measures _measures;
    private readonly string _work;
    private readonly string _renderScene;
    private readonly Stopwatch _clock = Stopwatch.StartNew();

    public SceneRun(BenchPlan plan)
    {
        _plan = plan;
        _work = Path.Combine(BenchPlan.Root, "artifacts", "bench", plan.Reduce == 1 ? "full" : "short");
        Directory.CreateDirectory(_work);
        Directory.CreateDirectory(plan.Folder);
        _measures = new Measures(Path.Combine(plan.Folder, "results.csv"));
        string name = OperatingSystem.IsWindows() ? "RenderScene.exe" : "RenderScene";
        _renderScene = Path.Combine(BenchPlan.Root, "samples", "RenderScene", "bin", "Release", "net10.0", name);
    }

    private static int[] Threads => Environment.ProcessorCount == 1 ? [1] : [1, 2];

    /// <summary>Measures everything; the report is written again after each part.</summary>
    public void Run()
    {
        MakeData();
        foreach (string name in s_scenes)
        {
            MeasureScene(name);
            BenchReport.Write(_plan, _measures);
        }

        new ErrorSweep(_plan, _measures, _work, Say).Run(Load("s5"));
        BenchReport.Write(_plan, _measures);
        new ScalingSweep(_plan, _measures, Say).Run();
        BenchReport.Write(_plan, _measures);
        Say($"report: {Path.Combine(_plan.Folder, "RESULTS.md")}");
    }

    /// <summary>The same scene in the size of the plan.</summary>
    /// <param name="plan">The plan.</param>
    /// <param name="threads">Threads.</param>
    /// <param name="precision">Precision of geometry.</param>
    /// <param name="samples">Samples a pixel.</param>
    public static RenderOptions Options(BenchPlan plan, int threads, Precision precision = Precision.Double, int samples = 1) =>
        new() { Width = plan.Width, Height = plan.Height, Threads = threads, Precision = precision, Samples = samples };

    private string ScenePath(string name) => Path.Combine(_work, $"{name}.json");

    private LoadedScene Load(string name) => SceneFile.Load(ScenePath(name));

    private void MakeData()
    {
        foreach (string name in s_scenes)
        {
            File.Copy(Path.Combine(BenchPlan.Root, "scenes", "bench", $"{name}.json"), ScenePath(name), overwrite: true);
        }

        string data = Path.Combine(_work, "data");
        if (!File.Exists(Path.Combine(data, "torus.obj")))
        {
            Say("makes the pictures and the torus");
            ChildProcess.Run(_renderScene, _work, "bench-data", data, "--reduce", FormattableString.Invariant($"{_plan.Reduce}"));
        }
    }

    private void MeasureScene(string name)
    {
        Say($"{name}: reads");
        LoadedScene scene = Load(name);
        string? pov = PovRay.IsInstalled ? PovScene.Write(scene, _work, name, _plan.Width, _plan.Height) : null;
        Warm(scene.Scene);
        for (int round = 1; round <= _plan.Rounds; round++)
        {
            Say($"{name}: round {round} of {_plan.Rounds}");
            foreach (int threads in Threads)
            {
                MeasurePicture(name, scene.Scene, threads, Precision.Double);
                MeasurePicture(name, scene.Scene, threads, Precision.Single);
                MeasurePov(name, pov, threads);
            }

            MeasureProcess(name);
        }

        if (pov is not null)
        {
            PictureDifference difference = PictureDifference.Compare(LoadLinear(Path.Combine(_work, $"{name}.png")), LoadLinear(Path.Combine(_work, $"{name}-pov.png")));
            _measures.Add(name, Pov, "against LabRaytracer", "rmse", difference.Rmse);
        }
    }

    /// <summary>The first renders compile code; they are not counted.</summary>
    private void Warm(Scene scene)
    {
        foreach (Precision precision in (Precision[])[Precision.Double, Precision.Single, Precision.Double, Precision.Single])
        {
            Renderer.Render(scene, Options(_plan, Threads[^1], precision));
        }
    }

    private void MeasurePicture(string name, Scene scene, int threads, Precision precision)
    {
        string variant = FormattableString.Invariant($"{(precision == Precision.Double ? "double" : "float")}, {threads} thread{(threads == 1 ? "" : "s")}");
        _measures.Add(name, Ours, variant, "picture", Turn(scene, Options(_plan, threads, precision)));
    }

    /// <summary>A contender's turn is about as long for all: the middle one of the pictures that fit in, of at least three.</summary>
    private static double Turn(Scene scene, RenderOptions options)
    {
        const double Seconds = 0.5;
        double sum = 0;
        List<double> times = [];
        Picture picture = First(scene, options);
        while (times.Count < 3 || (sum < Seconds && times.Count < 15))
        {
            times.Add(Renderer.RenderInto(scene, options, picture).RenderSeconds);
            sum += times[^1];
        }

        return times.Order().ElementAt(times.Count / 2);
    }

    /// <summary>A first picture, which is not counted: the system gives memory page by page as it is written to.</summary>
    private static Picture First(Scene scene, RenderOptions options) => Renderer.Render(scene, options).Picture;

    /// <summary>Time of a picture whose memory is there.</summary>
    public static RenderStatistics RenderWarm(Scene scene, RenderOptions options) => Renderer.RenderInto(scene, options, First(scene, options));

    private void MeasureProcess(string name)
    {
        string size = FormattableString.Invariant($"{_plan.Width}x{_plan.Height}");
        ChildProcess.Outcome outcome = ChildProcess.Run(_renderScene, _work, "render", ScenePath(name), "-o", Path.Combine(_work, $"{name}.png"), "--size", size, "--quiet");
        _measures.Add(name, Ours, "all threads", "process", outcome.Seconds);
        _measures.Add(name, Ours, "all threads", "peak MB", outcome.PeakMegabytes);
    }

    private void MeasurePov(string name, string? pov, int threads)
    {
        if (pov is null)
        {
            return;
        }

        (ChildProcess.Outcome process, double trace) = PovRay.Render(pov, Path.Combine(_work, $"{name}-pov.png"), _plan, "-A", threads);
        string variant = FormattableString.Invariant($"-A, {threads} thread{(threads == 1 ? "" : "s")}");
        _measures.Add(name, Pov, variant, "picture", trace);
        if (threads == Threads[^1])
        {
            _measures.Add(name, Pov, "all threads", "process", process.Seconds);
            _measures.Add(name, Pov, "all threads", "peak MB", process.PeakMegabytes);
        }
    }

    /// <summary>Both programs write code = 255 times light, whatever the file says.</summary>
    internal static Picture LoadLinear(string path) => Picture.FromPixels(PictureCodecs.Default.Read(path).WithTransfer(TransferFunction.Linear));

    private void Say(string line) => Console.WriteLine(FormattableString.Invariant($"{_clock.Elapsed.TotalSeconds,7:0.0} s  {line}"));
}
