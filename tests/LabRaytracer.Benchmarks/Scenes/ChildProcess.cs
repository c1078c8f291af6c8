using System.ComponentModel;
using System.Diagnostics;

namespace LabRaytracer.Benchmarks;

/// <summary>Programs that are started, waited for and measured from outside.</summary>
internal static class ChildProcess
{
    /// <summary>What a finished program did.</summary>
    /// <param name="Seconds">From start to exit.</param>
    /// <param name="PeakMegabytes">Largest resident memory that was seen, 10^6 bytes.</param>
    /// <param name="Error">What it wrote to the error stream.</param>
    public sealed record Outcome(double Seconds, double PeakMegabytes, string Error);

    /// <summary>Runs a program.</summary>
    /// <exception cref="InvalidOperationException">It failed.</exception>
    public static Outcome Run(string program, string folder, params IEnumerable<string> arguments)
    {
        ProcessStartInfo start = new(program, arguments) { WorkingDirectory = folder, RedirectStandardError = true, RedirectStandardOutput = true, RedirectStandardInput = true };
        start.Environment.Remove("DOTNET_TieredCompilation");
        Stopwatch clock = Stopwatch.StartNew();
        using Process process = Process.Start(start)!;
        process.StandardInput.Close();
        Task<string> output = process.StandardOutput.ReadToEndAsync(), error = process.StandardError.ReadToEndAsync();
        long peak = 0;
        do
        {
            peak = Math.Max(peak, Peak(process));
        }
        while (!process.WaitForExit(20));
        double seconds = clock.Elapsed.TotalSeconds;
        Task.WaitAll(output, error);
        return process.ExitCode == 0
            ? new Outcome(seconds, peak / 1e6, error.Result)
            : throw new InvalidOperationException($"{program} {string.Join(' ', start.ArgumentList)}: exit code {process.ExitCode}. {error.Result}");
    }

    /// <summary>Tells whether a program can be started.</summary>
    public static bool Exists(string program, string argument)
    {
        try
        {
            using Process process = Process.Start(new ProcessStartInfo(program, argument) { RedirectStandardError = true, RedirectStandardOutput = true })!;
            process.WaitForExit();
            return true;
        }
        catch (Win32Exception)
        {
            return false;
        }
    }

    private static long Peak(Process process)
    {
        try
        {
            process.Refresh();
            return process.PeakWorkingSet64;
        }
        catch (InvalidOperationException)
        {
            return 0;
        }
    }
}
