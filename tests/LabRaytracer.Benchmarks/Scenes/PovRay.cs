using System.Globalization;
using System.Text.RegularExpressions;

namespace LabRaytracer.Benchmarks;

/// <summary>POV-Ray as the system has it.</summary>
internal static partial class PovRay
{
    private const string Program = "povray";

    /// <summary>Tells whether it is installed.</summary>
    public static bool IsInstalled { get; } = ChildProcess.Exists(Program, "--version");

    /// <summary>Renders a scene.</summary>
    /// <param name="scene">Path of the .pov file.</param>
    /// <param name="picture">Path of the PNG file.</param>
    /// <param name="options">Size of the picture, and of the run.</param>
    /// <param name="sampling">Options of anti-aliasing, such as -A.</param>
    /// <param name="threads">Threads.</param>
    /// <returns>The process, and the seconds of tracing as POV-Ray prints them.</returns>
    public static (ChildProcess.Outcome Process, double TraceSeconds) Render(string scene, string picture, BenchPlan options, string sampling, int threads)
    {
        string[] words =
        [
            Invariant($"+I{scene}"), Invariant($"+O{picture}"), "+FN8", Invariant($"+W{options.Width}"), Invariant($"+H{options.Height}"), Invariant($"+WT{threads}"), "-D",
            "File_Gamma=1.0", .. sampling.Split(' '),
        ];
        ChildProcess.Outcome outcome = ChildProcess.Run(Program, Path.GetDirectoryName(scene)!, words);
        Match trace = TraceTime().Match(outcome.Error);
        return (outcome, trace.Success ? double.Parse(trace.Groups[1].Value, CultureInfo.InvariantCulture) : double.NaN);
    }

    private static string Invariant(FormattableString text) => FormattableString.Invariant(text);

    [GeneratedRegex(@"Trace Time:[^(]*\(([0-9.]+) seconds\)")]
    private static partial Regex TraceTime();
}
