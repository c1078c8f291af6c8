using System.Globalization;
using RenderScene;

namespace LabRaytracer.Benchmarks;

/// <summary>frontier [--short | --long]: time against error of every filter, beside POV-Ray's, on four scenes of textures seen from afar.</summary>
internal static class FrontierCommand
{
    private static readonly string[] s_scenes = ["s5", "f0", "f1", "f2"];

    private static readonly string[] s_povOptions = ["-A", "+A0.3 +R3 -J", "+A0.1 +R4 -J"];

    /// <summary>Runs the command; 0 if all was measured, 2 if the words are wrong.</summary>
    public static int Run(string[] words)
    {
        if (words.Length > 1 || (words.Length == 1 && words[0] is not ("--short" or "--long")))
        {
            Console.Error.WriteLine($"'{string.Join(' ', words)}' is not understood here. Allowed: frontier [--short | --long].");
            return 2;
        }

        bool isShort = words is ["--short"], isLong = words is ["--long"];
        (int width, int height, int samples) = isShort ? (192, 108, 256) : isLong ? (1920, 1080, 4096) : (480, 270, 4096);
        string work = Path.Combine(BenchPlan.Root, "artifacts", "frontier");
        string results = isShort ? work : Path.Combine(BenchPlan.Root, "tests", "LabRaytracer.Benchmarks", "Frontier");
        Prepare(work);
        foreach (string name in s_scenes)
        {
            Measure(name, work, results, width, height, samples);
        }

        return 0;
    }

    private static void Measure(string name, string work, string results, int width, int height, int samples)
    {
        string path = Path.Combine(work, $"{name}.json");
        LoadedScene scene = SceneFile.Load(path);
        FrontierSweep sweep = new(scene, width, height);
        Console.WriteLine($"{name}: converged picture");
        Picture converged = sweep.Converged(samples, path, Path.Combine(work, "converged"), default);
        List<FrontierPoint> points = sweep.Run(converged, Say, default);
        if (PovRay.IsInstalled && PovScene.CanWrite(scene.Scene))
        {
            points.AddRange(MeasurePov(name, scene, work, converged, sweep.Inner));
        }

        string remark = string.Create(
            CultureInfo.InvariantCulture,
            $"{width} x {height} pixels, one thread, the shortest of three renders; errors of linear light against {samples} samples a pixel, of all pixels and of those that no edge of an object crosses. POV-Ray's 8-bit files add at most 0.002.");
        FrontierReport.Write(results, name, $"{name}: time against error", remark, points);
    }

    /// <summary>POV-Ray's pictures without and with its interpolation, each way of anti-aliasing once.</summary>
    private static IEnumerable<FrontierPoint> MeasurePov(string name, LoadedScene scene, string work, Picture converged, InnerPixels inner)
    {
        BenchPlan plan = new() { Command = "frontier", Folder = work, Width = converged.Width, Height = converged.Height };
        foreach (string interpolate in new[] { "", "interpolate 2" })
        {
            string path = PovScene.Write(scene, work, name, plan.Width, plan.Height, interpolate), picture = Path.Combine(work, $"{name}-pov.png");
            foreach (string options in s_povOptions)
            {
                double seconds = PovRay.Render(path, picture, plan, options, threads: 1).TraceSeconds;
                Picture linear = SceneRun.LoadLinear(picture);
                FrontierPoint point = new($"POV-Ray {interpolate}".Trim(), options, seconds, FrontierSweep.Rmse(linear, converged), inner.Rmse(linear, converged));
                Say(point);
                yield return point;
            }
        }
    }

    /// <summary>Scenes and the pictures that they name, side by side.</summary>
    private static void Prepare(string work)
    {
        string textures = Path.Combine(work, "textures");
        Directory.CreateDirectory(textures);
        foreach (string name in s_scenes)
        {
            File.Copy(Path.Combine(BenchPlan.Root, "scenes", "bench", $"{name}.json"), Path.Combine(work, $"{name}.json"), overwrite: true);
            File.SetLastWriteTimeUtc(Path.Combine(work, $"{name}.json"), File.GetLastWriteTimeUtc(Path.Combine(BenchPlan.Root, "scenes", "bench", $"{name}.json")));
        }

        File.Copy(Path.Combine(BenchPlan.Root, "scenes", "textures", "earth-2048x1024.png"), Path.Combine(textures, "earth-2048x1024.png"), overwrite: true);
        if (!File.Exists(Path.Combine(work, "data", "checker_fine.png")))
        {
            string program = Path.Combine(BenchPlan.Root, "samples", "RenderScene", "bin", "Release", "net10.0", OperatingSystem.IsWindows() ? "RenderScene.exe" : "RenderScene");
            ChildProcess.Run(program, work, "bench-data", Path.Combine(work, "data"));
        }
    }

    private static void Say(FrontierPoint point) =>
        Console.WriteLine(string.Create(CultureInfo.InvariantCulture, $"  {point.Series,-22} {point.Variant,-14} {point.Seconds,9:0.0000} s   RMSE {point.Rmse:0.00000}, inside objects {point.InnerRmse:0.00000}"));
}
