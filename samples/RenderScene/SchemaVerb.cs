using System.CommandLine;
using LabRaytracer;

namespace RenderScene;

/// <summary>schema: the JSON schema of scene files, for editors.</summary>
internal static class SchemaVerb
{
    /// <summary>The verb for the command line.</summary>
    public static Command Create(AppConsole console)
    {
        Command command = new("schema", "Prints the JSON schema of scene files, which editors use to complete and check them.");
        command.SetAction(_ =>
        {
            console.Output.Write(SceneSchema.Generate());
            return ExitCode.Done;
        });
        return command;
    }
}
