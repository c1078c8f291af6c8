using System.Diagnostics;
using System.Globalization;
using RenderScene;

namespace LabRaytracer.Tests.Samples;

/// <summary>The program as a process of its own.</summary>
public sealed class SignalTests
{
    private const int Patience = 30_000;

    [Fact]
    public void Render_SigTerm_EndsSoonAndKeepsTheOldPicture()
    {
        if (OperatingSystem.IsWindows())
        {
            return;
        }

        using TestFolder folder = new();
        File.WriteAllText(folder["a.png"], "old");
        using Process program = Start(folder, "--size", "2000x1000", "--samples", "36");

        // The first line of progress: the render is under way.
        Assert.NotNull(program.StandardError.ReadLine());
        using Process kill = Process.Start("kill", ["-TERM", program.Id.ToString(CultureInfo.InvariantCulture)]);
        Assert.True(program.WaitForExit(Patience), "the program did not end");
        Assert.Equal(ExitCode.Terminated, program.ExitCode);
        Assert.Equal("old", File.ReadAllText(folder["a.png"]));
        Assert.Equal(["a.png", "small.json"], folder.Files);
    }

    private static Process Start(TestFolder folder, params string[] options)
    {
        string program = Path.Combine(AppContext.BaseDirectory, "RenderScene.dll");
        ProcessStartInfo start = new("dotnet", [program, "render", ProgramRun.WriteScene(folder), "-o", folder["a.png"], .. options])
        {
            RedirectStandardError = true, RedirectStandardOutput = true, UseShellExecute = false,
        };
        return Process.Start(start)!;
    }
}
