using RenderScene;

namespace LabRaytracer.Tests.Samples;

/// <summary>One run of the sample program inside the test's process.</summary>
internal sealed record ProgramRun(int Code, string Output, string Error)
{
    /// <summary>Runs a command line.</summary>
    public static ProgramRun Of(params string[] arguments) => Of(CancellationToken.None, arguments);

    /// <summary>Runs a command line that can be stopped.</summary>
    public static ProgramRun Of(CancellationToken stop, params string[] arguments)
    {
        using StringWriter output = new() { NewLine = "\n" }, error = new() { NewLine = "\n" };
        int code = App.Run(arguments, new AppConsole(output, error, ProgressStyle.Lines), stop);
        return new ProgramRun(code, output.ToString(), error.ToString());
    }

    /// <summary>A small scene with one sphere in a folder.</summary>
    public static string WriteScene(TestFolder folder, string name = "small.json")
    {
        const string Scene = """
            // A white ball.
            {
              "render": { "width": 32, "height": 18 },
              "objects": [ { "shape": "sphere" } ],
              "lights": [ { "type": "point", "position": [2, 3, 4], "intensity": 0.8 } ]
            }
            """;
        File.WriteAllText(folder[name], Scene);
        return folder[name];
    }
}
