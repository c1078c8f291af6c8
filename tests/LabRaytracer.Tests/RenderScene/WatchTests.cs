using RenderScene;

namespace LabRaytracer.Tests.Samples;

public sealed class WatchTests
{
    private static readonly TimeSpan s_patience = TimeSpan.FromSeconds(30);

    [Fact]
    public async Task Render_WatchedTexture_RendersAgainAfterAMistakeAndAfterItsCorrection()
    {
        using TestFolder folder = new();
        File.WriteAllText(folder["a.ppm"], "P3 1 1 255 255 0 0\n");
        File.WriteAllText(folder["s.json"], """
            {
              "render": { "width": 4, "height": 4 },
              "objects": [ { "shape": "sphere", "material": { "emission": { "texture": { "type": "image", "file": "a.ppm" } }, "diffuse": 0 } } ]
            }
            """);
        using Watched run = new("render", folder["s.json"], "-o", folder["s.png"], "--watch", "--size", "4x4");
        await run.Until("watching the scene and 1 of its files");
        Assert.Equal(new Intensity(1, 0, 0), Picture.Load(folder["s.png"])[2, 2]);

        File.WriteAllText(folder["a.ppm"], "no picture");
        await run.Until("error:", "watching");
        Assert.Equal(new Intensity(1, 0, 0), Picture.Load(folder["s.png"])[2, 2]);

        File.WriteAllText(folder["a.ppm"], "P3 1 1 255 0 255 0\n");
        await run.Until("watching");
        Assert.Equal(new Intensity(0, 1, 0), Picture.Load(folder["s.png"])[2, 2]);
        Assert.Equal(ExitCode.Cancelled, await run.Stop());
        Assert.Equal(["a.ppm", "s.json", "s.png"], folder.Files);
    }

    [Fact]
    public async Task Render_WatchedSceneWithAMistakeFromTheStart_WaitsForItsCorrection()
    {
        using TestFolder folder = new();
        File.WriteAllText(folder["small.json"], "{ \"objects\": [ { \"shape\": \"spere\" } ] }");
        using Watched run = new("render", folder["small.json"], "-o", folder["a.png"], "--watch");
        await run.Until("small.json:1:", "watching the scene file");
        ProgramRun.WriteScene(folder);
        await run.Until("watching the scene file");
        Assert.Equal(32, Picture.Load(folder["a.png"]).Width);
        Assert.Equal(ExitCode.Cancelled, await run.Stop());
    }

    [Fact]
    public void Render_WatchWithABadOption_EndsAtOnce()
    {
        using TestFolder folder = new();
        Assert.Equal(ExitCode.Usage, ProgramRun.Of("render", ProgramRun.WriteScene(folder), "--watch", "--samples", "5").Code);
    }

    [Fact]
    public void WaitForChange_FileComesAndIsWrittenInSteps_ReturnsWhenItRests()
    {
        using TestFolder folder = new();
        WatchedFiles files = new();
        files.Add(folder["a"]);
        files.Add(folder["b"]);
        using CancellationTokenSource late = new(s_patience);
        File.WriteAllText(folder["b"], "1");
        Assert.True(files.WaitForChange(late.Token));

        // The first state counts: the same file added once more does not hide the change.
        files.Add(folder["b"]);
        Assert.True(files.WaitForChange(late.Token));
        files.Remove(folder["b"]);
        using CancellationTokenSource soon = new(TimeSpan.FromMilliseconds(250));
        Assert.False(files.WaitForChange(soon.Token));
    }

    [Fact]
    public void FileNamed_SceneWithMissingFile_IsToldAllTheSame()
    {
        using TestFolder folder = new();
        string scene = folder["s.json"];
        File.WriteAllText(scene, "{ \"objects\": [ { \"shape\": \"mesh\", \"file\": \"none.obj\" } ] }");
        List<string> named = [];
        Assert.Throws<SceneFileException>(() => SceneFile.Load(scene, new SceneLoadOptions { FileNamed = named.Add }));
        Assert.Equal([folder["none.obj"]], named);
    }

    /// <summary>A run that goes on until it is stopped.</summary>
    private sealed class Watched : IDisposable
    {
        private readonly CancellationTokenSource _stop = new();
        private readonly LineQueue _error = new();
        private readonly Task<int> _run;

        public Watched(params string[] arguments)
        {
            _run = Task.Run(() =>
            {
                using StringWriter output = new();
                return App.Run(arguments, new AppConsole(output, TextWriter.Synchronized(_error), ProgressStyle.None), _stop.Token);
            });
        }

        /// <summary>Waits for messages that contain some words, in this order.</summary>
        public async Task Until(params string[] words)
        {
            foreach (string word in words)
            {
                await _error.Until(word).WaitAsync(s_patience);
            }
        }

        public Task<int> Stop()
        {
            _stop.Cancel();
            return _run.WaitAsync(s_patience);
        }

        public void Dispose()
        {
            _stop.Cancel();
            _run.Wait(s_patience);
            _error.Dispose();
            _stop.Dispose();
        }
    }
}
