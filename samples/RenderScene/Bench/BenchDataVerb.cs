using System.CommandLine;
using System.Diagnostics;
using System.Globalization;

namespace RenderScene;

/// <summary>bench-data FOLDER: makes the pictures and the mesh that the scenes of scenes/bench need.</summary>
internal static class BenchDataVerb
{
    /// <summary>The verb for the command line.</summary>
    public static Command Create(AppConsole console, CancellationToken stop)
    {
        Argument<string> folder = new("folder") { Description = "Where the files go: scenes/bench/data for the scenes of scenes/bench." };
        Option<string?> reduce = new("--reduce") { HelpName = "N", Description = "Divide all sides by 1, 2, 4, 8 or 16, for tests. Default: 1." };
        Command command = new("bench-data", "Makes the pictures and the mesh (150 MB) that the scenes of scenes/bench need; the same bytes each time.") { folder, reduce };
        command.SetAction(parsed =>
        {
            int divisor = parsed.GetValue(reduce) is { } text ? OptionText.Word("--reduce", text, Enumerable.Range(0, 5).ToDictionary(n => (1 << n).ToString(CultureInfo.InvariantCulture), n => 1 << n)) : 1;
            Stopwatch clock = Stopwatch.StartNew();
            string target = parsed.GetRequiredValue(folder);
            ProgressDisplay.Run(console, "bench data", progress =>
            {
                new BenchData(target, divisor).Write(progress, stop);
                return true;
            });
            console.Output.WriteLine(string.Create(CultureInfo.InvariantCulture, $"{target}: tex0.png to tex7.png, checker.png, checker_fine.png, torus.obj in {clock.Elapsed.TotalSeconds:0.0} s"));
            return ExitCode.Done;
        });
        return command;
    }
}
