using System.CommandLine;
using System.Diagnostics;
using System.Globalization;
using LabRaytracer;

namespace RenderScene;

/// <summary>render SCENE: a scene file becomes a picture file.</summary>
internal sealed class RenderVerb
{
    private readonly Argument<string> _scene = new("scene") { Description = "The scene file, such as scenes/06-earth.json." };

    private readonly Option<string?> _output = new("--output", "-o") { HelpName = "FILE", Description = "The picture: .png, .ppm, .pfm or .hdr. Default: out/NAME-OF-SCENE.png." };

    private readonly Option<bool> _stats = new("--stats") { Description = "Print what was done, what was skipped, and how long it took." };

    private readonly Option<string?> _statsJson = new("--stats-json") { HelpName = "FILE", Description = "Write the same as JSON." };

    private readonly Option<bool> _quiet = new("--quiet", "-q") { Description = "No progress and no summary." };

    private readonly Option<bool> _allowPath = new("--allow-path") { Description = "Let the scene name files outside its own folder." };

    private readonly RenderSettings _settings = new();

    /// <summary>The verb for the command line.</summary>
    public static Command Create(AppConsole console, CancellationToken stop)
    {
        RenderVerb verb = new();
        Command command = new("render", "Renders a scene file into a picture file.") { verb._scene, verb._output };
        foreach (Option option in verb._settings.All.Concat([verb._allowPath, verb._stats, verb._statsJson, verb._quiet]))
        {
            command.Options.Add(option);
        }

        command.SetAction(parsed => verb.Run(parsed, console, stop));
        return command;
    }

    private int Run(ParseResult parsed, AppConsole console, CancellationToken stop)
    {
        string scenePath = parsed.GetRequiredValue(_scene);
        if (parsed.GetValue(_quiet))
        {
            console = console with { Progress = ProgressStyle.None };
        }

        Stopwatch clock = Stopwatch.StartNew();
        LoadedScene scene = SceneInput.Load(scenePath, new SceneLoadOptions { AllowOutsidePaths = parsed.GetValue(_allowPath) });
        double loadSeconds = clock.Elapsed.TotalSeconds;
        RenderOptions options = _settings.Apply(parsed, scene.RenderOptions);
        string output = parsed.GetValue(_output) ?? PictureOutput.DefaultPath(scene.Output.FileName ?? $"{Path.GetFileNameWithoutExtension(scenePath)}.png");
        string? statsFile = parsed.GetValue(_statsJson);
        PictureOutput.Check(output, statsFile);
        PictureSaveOptions save = PictureOutput.WithText(scene.Output.Picture, PictureOutput.Text(scenePath, options));
        RenderStatistics statistics = SceneInput.Render(scene, Path.GetFileName(scenePath), options, output, save, console, stop);
        StatisticsReport report = new(scenePath, output, options, statistics) { LoadSeconds = loadSeconds, TotalSeconds = clock.Elapsed.TotalSeconds };
        if (statsFile is not null)
        {
            AtomicFile.Write(statsFile, report.WriteJson);
        }

        if (parsed.GetValue(_stats))
        {
            report.WriteText(console.Output);
        }
        else if (!parsed.GetValue(_quiet))
        {
            PixelRectangle area = Renderer.Area(options);
            console.Output.WriteLine(string.Create(
                CultureInfo.InvariantCulture, $"{output}: {area.Width} x {area.Height} pixels in {clock.Elapsed.TotalSeconds:0.00} s"));
        }

        StatisticsReport.WarnOfNotFinite(statistics, console.Error);
        return ExitCode.Done;
    }
}
