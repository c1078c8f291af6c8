using System.CommandLine;
using System.Reflection;
using LabRaytracer;

namespace RenderScene;

/// <summary>version: which LabRaytracer this is.</summary>
internal static class VersionVerb
{
    /// <summary>Version of the library, such as 0.1.0, without the build's own marks.</summary>
    public static string Version { get; } =
        (typeof(Scene).Assembly.GetCustomAttribute<AssemblyInformationalVersionAttribute>()?.InformationalVersion ?? "unknown").Split('+')[0];

    /// <summary>The verb for the command line.</summary>
    public static Command Create(AppConsole console)
    {
        Command command = new("version", "Prints the version.");
        command.SetAction(_ =>
        {
            console.Output.WriteLine($"LabRaytracer {Version}");
            return ExitCode.Done;
        });
        return command;
    }
}
