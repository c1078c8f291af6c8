using System.Globalization;
using System.Runtime.InteropServices;

namespace LabRaytracer.Benchmarks;

/// <summary>skipping [SCENE.json ...]: the same scenes with and without skipping, in turns; whether the bits agree, what was saved and what the statistics had estimated.</summary>
internal static class SkippingCommand
{
    private const int Rounds = 9;

    private static readonly string[] s_scenes =
        ["01-constant", "06-earth", "08-lab-texels", "09-reflection-refraction", "12-environment", "bench/s1", "bench/s2", "bench/s3"];

    public static int Run(string[] words)
    {
        string[] paths = words.Length > 0 ? words : [.. s_scenes.Select(name => Path.Combine(BenchPlan.Root, "scenes", name + ".json"))];
        string? missing = paths.FirstOrDefault(path => !File.Exists(path));
        if (missing is not null)
        {
            Console.Error.WriteLine($"error: there is no scene '{missing}'; name others: skipping [SCENE.json ...].");
            return 2;
        }

        Line($"480 x 270, 1 thread, best of {Rounds} rounds in turns, processor time; {RuntimeInformation.FrameworkDescription}");
        Line($"| scene | with skipping, ms | without | ratio | estimated saving, ms | bits |");
        Line($"|---|---|---|---|---|---|");
        bool agree = true;
        foreach (string path in paths)
        {
            agree &= Measure(path);
        }

        return agree ? 0 : 1;
    }

    private static bool Measure(string path)
    {
        Scene scene = SceneFile.Load(path).Scene;
        double on = double.PositiveInfinity, off = double.PositiveInfinity;
        RenderResult? with = null, without = null;
        for (int round = 0; round < Rounds; round++)
        {
            on = Math.Min(on, Time(scene, Skipping.On, out with));
            off = Math.Min(off, Time(scene, Skipping.Off, out without));
        }

        bool agree = MemoryMarshal.AsBytes<Intensity>(with!.Picture.Pixels).SequenceEqual(MemoryMarshal.AsBytes<Intensity>(without!.Picture.Pixels));
        double estimate = with.Statistics.Skipped.Sum(work => work.Seconds ?? 0);
        Line($"| {Path.GetFileNameWithoutExtension(path)} | {1000 * on:0.0} | {1000 * off:0.0} | {off / on:0.00} | {1000 * estimate:0.0} | {(agree ? "same" : "DIFFERENT")} |");
        return agree;
    }

    private static double Time(Scene scene, Skipping skipping, out RenderResult result)
    {
        TimeSpan before = Environment.CpuUsage.TotalTime;
        result = Renderer.Render(scene, new RenderOptions { Width = 480, Height = 270, Threads = 1, Skipping = skipping });
        return (Environment.CpuUsage.TotalTime - before).TotalSeconds;
    }

    private static void Line(FormattableString line) => Console.WriteLine(line.ToString(CultureInfo.InvariantCulture));
}
