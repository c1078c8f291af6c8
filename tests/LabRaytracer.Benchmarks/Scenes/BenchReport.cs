using System.Globalization;
using System.Runtime.InteropServices;
using System.Text;
using RenderScene;

namespace LabRaytracer.Benchmarks;

/// <summary>Writes RESULTS.md and the plots.</summary>
internal sealed class BenchReport(BenchPlan plan, Measures measures)
{
    private readonly StringBuilder _text = new();

    /// <summary>Writes what has been measured so far.</summary>
    public static void Write(BenchPlan plan, Measures measures) => new BenchReport(plan, measures).Write();

    private static string Processor
    {
        get
        {
            string? line = File.Exists("/proc/cpuinfo") ? File.ReadLines("/proc/cpuinfo").FirstOrDefault(line => line.StartsWith("model name", StringComparison.Ordinal)) : null;
            return line?.Split(':', 2)[1].Trim() ?? RuntimeInformation.ProcessArchitecture.ToString();
        }
    }

    private void Write()
    {
        Line($"# Whole scenes, measured");
        Line($"{DateTime.UtcNow:yyyy-MM-dd}, {Processor}, {Environment.ProcessorCount} processors, lanes of {LaneWidth.Best} floats, {RuntimeInformation.FrameworkDescription}, {RuntimeInformation.OSDescription}.");
        Line($"");
        Line($"`dotnet run -c Release --project tests/LabRaytracer.Benchmarks -- {plan.Command}`: {plan.Width} x {plan.Height} pixels, 1 sample; medians of {plan.Rounds} rounds in which the contenders take turns. Trust ratios more than times.");
        Line($"All values: [results.csv](results.csv). POV-Ray renders the same scenes without anti-aliasing (-A); its picture time is the trace time that it prints. RMSE compares the two programs' picture files: a check that they render the same scene.");
        WritePictures();
        WriteProcesses();
        WriteError();
        WriteScaling();
        File.WriteAllText(Path.Combine(plan.Folder, "RESULTS.md"), _text.ToString());
    }

    private void WritePictures()
    {
        Line($"");
        Line($"## Picture path, warm, ms");
        Line($"| scene | double, 1 thread | float, 1 thread | POV-Ray, 1 thread | ratio | double, 2 threads | float, 2 threads | POV-Ray, 2 threads | ratio | RMSE to POV-Ray |");
        Line($"|---|---|---|---|---|---|---|---|---|---|");
        foreach (string scene in (string[])["s1", "s2", "s3", "s4", "s5"])
        {
            string row = $"| {scene} |";
            foreach (string threads in (string[])["1 thread", "2 threads"])
            {
                double? ours = Picture(scene, SceneRun.Ours, $"double, {threads}"), pov = Picture(scene, SceneRun.Pov, $"-A, {threads}");
                row += $" {Text(1000 * ours)} | {Text(1000 * Picture(scene, SceneRun.Ours, $"float, {threads}"))} | {Text(1000 * pov)} | {Text(pov / ours)} |";
            }

            Line($"{row} {Text(measures.Median(scene, SceneRun.Pov, "against LabRaytracer", "rmse"))} |");
        }
    }

    private void WriteProcesses()
    {
        Line($"");
        Line($"## Whole process, cold, PNG written, all threads");
        Line($"| scene | seconds | POV-Ray | ratio | peak MB | POV-Ray |");
        Line($"|---|---|---|---|---|---|");
        foreach (string scene in (string[])["s1", "s2", "s3", "s4", "s5"])
        {
            double? ours = measures.Median(scene, SceneRun.Ours, "all threads", "process"), pov = measures.Median(scene, SceneRun.Pov, "all threads", "process");
            double? memory = measures.Median(scene, SceneRun.Ours, "all threads", "peak MB"), povMemory = measures.Median(scene, SceneRun.Pov, "all threads", "peak MB");
            Line($"| {scene} | {Text(ours)} | {Text(pov)} | {Text(pov / ours)} | {Text(memory)} | {Text(povMemory)} |");
        }
    }

    private void WriteError()
    {
        SvgPlot plot = new("s5: time against error, one thread", "seconds", "RMSE against the converged picture");
        Line($"");
        Line($"## Time against error: s5, one thread");
        Line($"Converged: {plan.ReferenceSamples} jittered samples a pixel. POV-Ray's 8-bit files add at most 0.002.");
        Line($"");
        Line($"![time against error](error.svg)");
        Line($"");
        Line($"| program | how | seconds | RMSE |");
        Line($"|---|---|---|---|");
        foreach (string program in (string[])[SceneRun.Ours, SceneRun.Pov])
        {
            List<(double X, double Y)> points = [];
            foreach (Measure time in measures.All.Where(time => time.Scene == ErrorSweep.Name && time.Program == program && time.Quantity == "picture"))
            {
                double rmse = measures.Median(ErrorSweep.Name, program, time.Variant, "rmse") ?? double.NaN;
                points.Add((time.Median, rmse));
                Line($"| {program} | {time.Variant} | {Text(time.Median)} | {Text(rmse)} |");
            }

            plot.Add(program, points);
        }

        plot.Write(Path.Combine(plan.Folder, "error.svg"));
    }

    private void WriteScaling()
    {
        SvgPlot plot = new("Time a pixel against the size of the scene", "objects", "nanoseconds a pixel");
        Line($"");
        Line($"## Size of the scene, double precision, all threads");
        Line($"![time a pixel](scaling.svg)");
        Line($"");
        Line($"| scene | ns a pixel | made ready, s |");
        Line($"|---|---|---|");
        foreach (string kind in (string[])[ScalingSweep.Spheres, ScalingSweep.Triangles])
        {
            List<(double X, double Y)> points = [];
            foreach (Measure time in measures.All.Where(time => time.Scene.StartsWith($"{kind} ", StringComparison.Ordinal) && time.Quantity == "picture"))
            {
                double nanoseconds = 1e9 * time.Median / ((double)plan.Width * plan.Height);
                points.Add((double.Parse(time.Scene[(kind.Length + 1)..], CultureInfo.InvariantCulture), nanoseconds));
                Line($"| {time.Scene} | {Text(nanoseconds)} | {Text(measures.Median(time.Scene, time.Program, time.Variant, "prepare"))} |");
            }

            plot.Add(kind, points);
        }

        plot.Write(Path.Combine(plan.Folder, "scaling.svg"));
    }

    private double? Picture(string scene, string program, string variant) => measures.Median(scene, program, variant, "picture");

    private static string Text(double? value) => value is { } number && double.IsFinite(number) ? number.ToString(Math.Abs(number) >= 100 ? "0" : "G3", CultureInfo.InvariantCulture) : "-";

    private void Line(FormattableString line) => _text.Append(line.ToString(CultureInfo.InvariantCulture)).Append('\n');
}
