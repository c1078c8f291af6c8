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

    private readonly Option<bool> _preview = new("--preview") { Description = "Show the picture in the terminal too, small; never in a pipe, nor with NO_COLOR or TERM=dumb." };

    private readonly Option<bool> _watch = new("--watch")
    {
        Description = "Render again whenever the scene file, or a picture or mesh that it names, changes; mistakes are printed and the next change is waited for. Ctrl-C ends.",
    };

    private readonly Option<bool> _allowMissing = new("--allow-missing") { Description = "Show a magenta and black checker for pictures that are missing or damaged, and warn." };

    private readonly RenderSettings _settings = new();

    private readonly OutputSettings _outputSettings = new();

    /// <summary>The verb for the command line.</summary>
    public static Command Create(AppConsole console, CancellationToken stop)
    {
        RenderVerb verb = new();
        Command command = new("render", "Renders a scene file into a picture file.") { verb._scene, verb._output };
        foreach (Option option in verb._settings.All.Concat(verb._outputSettings.All).Concat([verb._allowPath, verb._allowMissing, verb._stats, verb._statsJson, verb._preview, verb._watch, verb._quiet]))
        {
            command.Options.Add(option);
        }

        command.SetAction(parsed => verb.Run(parsed, console, stop));
        return command;
    }

    private int Run(ParseResult parsed, AppConsole console, CancellationToken stop)
    {
        if (parsed.GetValue(_quiet))
        {
            console = console with { Progress = ProgressStyle.None };
        }

        WatchedFiles files = new();
        if (parsed.GetValue(_watch))
        {
            return Watch(parsed, console, files, stop);
        }

        RenderOnce(parsed, console, files, stop);
        return ExitCode.Done;
    }

    /// <summary>Renders, and again after every change, until it is stopped.</summary>
    private int Watch(ParseResult parsed, AppConsole console, WatchedFiles files, CancellationToken stop)
    {
        bool isFirst = true;
        do
        {
            try
            {
                RenderOnce(parsed, console, files, stop);
            }
            catch (Exception failure) when (!stop.IsCancellationRequested && !(isFirst && failure is UsageException))
            {
                FailureReport.Write(failure, console.Error);
            }

            isFirst = false;
            if (!parsed.GetValue(_quiet))
            {
                console.Error.WriteLine(files.Count == 1 ? "watching the scene file; Ctrl-C ends" : string.Create(
                    CultureInfo.InvariantCulture, $"watching the scene and {files.Count - 1} of its files; Ctrl-C ends"));
            }
        }
        while (files.WaitForChange(stop));
        return ExitCode.Cancelled;
    }

    /// <summary>Renders the scene as it is now.</summary>
    /// <param name="parsed">The command line.</param>
    /// <param name="console">Where to report.</param>
    /// <param name="files">Receives the scene file and the files that it names, each in the state before it is read.</param>
    /// <param name="stop">Stops it.</param>
    private void RenderOnce(ParseResult parsed, AppConsole console, WatchedFiles files, CancellationToken stop)
    {
        string scenePath = parsed.GetRequiredValue(_scene);
        files.Clear();
        files.Add(scenePath);
        Stopwatch clock = Stopwatch.StartNew();
        LoadedScene scene = SceneInput.Load(scenePath, new SceneLoadOptions
        {
            AllowOutsidePaths = parsed.GetValue(_allowPath),
            FileNamed = files.Add,
            MissingPictures = parsed.GetValue(_allowMissing) ? MissingPictures.Checker : MissingPictures.Refused,
            Warned = warning => console.Error.WriteLine($"warning: {warning}"),
        });
        double loadSeconds = clock.Elapsed.TotalSeconds;
        RenderOptions options = _settings.Apply(parsed, scene.RenderOptions);
        string output = parsed.GetValue(_output) ?? PictureOutput.DefaultPath(scene.Output.FileName ?? $"{Path.GetFileNameWithoutExtension(scenePath)}.png");

        // A scene may show an earlier picture of itself: writing it is no change to wait for.
        files.Remove(output);
        PictureOutput.Check(output, parsed.GetValue(_statsJson));
        PictureSaveOptions save = _outputSettings.Apply(parsed, scene.Output.Picture);
        save = PictureOutput.WithText(save, PictureOutput.Text(scenePath, options, save));
        RenderStatistics statistics = SceneInput.Render(scene, Path.GetFileName(scenePath), options, output, save, console, stop);
        if (parsed.GetValue(_preview))
        {
            TerminalPreview.Show(output, console);
        }

        Report(parsed, console, new StatisticsReport(scenePath, output, options, statistics) { Pictures = PictureReport.Of(scene), LoadSeconds = loadSeconds, TotalSeconds = clock.Elapsed.TotalSeconds });
        StatisticsReport.WarnOfNotFinite(statistics, console.Error);
    }

    private void Report(ParseResult parsed, AppConsole console, StatisticsReport report)
    {
        if (parsed.GetValue(_statsJson) is { } statsFile)
        {
            AtomicFile.Write(statsFile, report.WriteJson);
        }

        if (parsed.GetValue(_stats))
        {
            report.WriteText(console.Output);
        }
        else if (!parsed.GetValue(_quiet))
        {
            report.WriteLine(console.Output);
        }
    }
}
