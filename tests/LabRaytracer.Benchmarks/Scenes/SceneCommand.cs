using System.Diagnostics;

namespace LabRaytracer.Benchmarks;

/// <summary>scenes [--short | --long] [--rounds N] [--out FOLDER]: measures whole scenes against POV-Ray and writes a report.</summary>
internal static class SceneCommand
{
    private const string CompileOnce = "DOTNET_TieredCompilation";

    /// <summary>Runs the command; 0 if all was measured, 2 if the words are wrong.</summary>
    public static int Run(string[] arguments)
    {
        // As RenderScene runs: code is compiled once, optimised. The runtime reads this only when a process starts.
        if (Environment.GetEnvironmentVariable(CompileOnce) != "0")
        {
            return RunAgain(arguments);
        }

        if (BenchPlan.TryParse(arguments, out BenchPlan? plan, out string message))
        {
            new SceneRun(plan!).Run();
            return 0;
        }

        Console.Error.WriteLine(message);
        return 2;
    }

    private static int RunAgain(string[] arguments)
    {
        ProcessStartInfo start = new(Environment.ProcessPath!) { UseShellExecute = false };
        if (Path.GetFileNameWithoutExtension(Environment.ProcessPath) == "dotnet")
        {
            start.ArgumentList.Add(typeof(SceneCommand).Assembly.Location);
        }

        foreach (string word in arguments.Prepend("scenes"))
        {
            start.ArgumentList.Add(word);
        }

        start.Environment[CompileOnce] = "0";
        using Process process = Process.Start(start)!;
        process.WaitForExit();
        return process.ExitCode;
    }
}
