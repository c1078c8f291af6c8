using System.CommandLine;

namespace RenderScene;

/// <summary>check SCENE: what is allowed in a scene but seldom meant.</summary>
internal static class CheckVerb
{
    /// <summary>The verb for the command line.</summary>
    public static Command Create(AppConsole console)
    {
        Argument<string> scene = new("scene") { Description = "The scene file." };
        Command command = new("check", "Looks for what is allowed in a scene but seldom meant: data read as sRGB, seams, stretched spheres, upside-down normal maps. Exit code 1 if there is any.")
        {
            scene,
        };
        command.SetAction(parsed =>
        {
            IReadOnlyList<string> findings = new SceneLint(SceneInput.Load(parsed.GetRequiredValue(scene))).Run();
            foreach (string finding in findings)
            {
                console.Output.WriteLine(finding);
            }

            console.Output.WriteLine(findings.Count == 0 ? "nothing found" : findings.Count == 1 ? "1 finding" : $"{findings.Count} findings");
            return findings.Count == 0 ? ExitCode.Done : ExitCode.CheckFailed;
        });
        return command;
    }
}
