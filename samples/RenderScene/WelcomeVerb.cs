using System.Diagnostics;
using System.Globalization;
using LabRaytracer;

namespace RenderScene;

/// <summary>No arguments: renders the lab's own scene and the earth, and says what to try next.</summary>
internal static class WelcomeVerb
{
    private static readonly string[] s_scenes = ["05-spherical-grid", "06-earth"];

    /// <summary>Renders both into the folder "out".</summary>
    public static int Run(AppConsole console, CancellationToken stop)
    {
        foreach (string name in s_scenes)
        {
            Stopwatch clock = Stopwatch.StartNew();
            string path = SampleScenes.File($"{name}.json"), output = PictureOutput.DefaultPath($"{name}.png");
            LoadedScene scene = SceneInput.Load(path);
            PictureOutput.Check(output);
            PictureSaveOptions save = PictureOutput.WithText(scene.Output.Picture, PictureOutput.Text(path, scene.RenderOptions, scene.Output.Picture));
            SceneInput.Render(scene, name, scene.RenderOptions, output, save, console, stop);
            console.Output.WriteLine(string.Create(CultureInfo.InvariantCulture, $"{output}: {SceneDescription.Read(path)} ({clock.Elapsed.TotalSeconds:0.00} s)"));
        }

        console.Output.WriteLine();
        console.Output.WriteLine("Try next, each after: dotnet run -c Release --project samples/RenderScene --");
        console.Output.WriteLine("  list                                                scenes, mappings, textures, shapes");
        console.Output.WriteLine("  render scenes/02-checker.json --size 640x360        a scene file becomes a picture; edit it and render again");
        console.Output.WriteLine("  render scenes/06-earth.json --view uv -o out/uv.png the texture coordinates that the mapping gives");
        console.Output.WriteLine("  figure 6                                            the figures 1 to 8 of the lab sheet");
        console.Output.WriteLine("  --help                                              all verbs and options");
        return ExitCode.Done;
    }
}
