using RenderScene;

namespace LabRaytracer.Tests.Samples;

/// <summary>The picture that was there before survives every failure.</summary>
public sealed class OutputSafetyTests
{
    private static readonly byte[] s_old = [1, 2, 3];

    [Fact]
    public void Render_FolderAsOutput_IsRefusedBeforeRendering()
    {
        using TestFolder folder = new();
        Directory.CreateDirectory(folder["a.png"]);
        ProgramRun run = ProgramRun.Of("render", ProgramRun.WriteScene(folder), "-o", folder["a.png"]);
        Assert.Equal(ExitCode.BadInput, run.Code);
        Assert.Contains("folder", run.Error, StringComparison.Ordinal);
        Assert.DoesNotContain("%", run.Error, StringComparison.Ordinal);
    }

    [Theory]
    [InlineData("-o")]
    [InlineData("--stats-json")]
    public void Render_OutputInMissingFolder_IsRefusedBeforeRendering(string option)
    {
        using TestFolder folder = new();
        string[] output = option == "-o" ? [] : ["-o", folder["a.png"]];
        ProgramRun run = ProgramRun.Of(["render", ProgramRun.WriteScene(folder), option, Path.Combine(folder["none"], "a.png"), .. output]);
        Assert.Equal(ExitCode.BadInput, run.Code);
        Assert.Contains("create it first", run.Error, StringComparison.Ordinal);
        Assert.DoesNotContain("%", run.Error, StringComparison.Ordinal);
        Assert.Equal(["small.json"], folder.Files);
    }

    [Fact]
    public void Render_CorruptTexture_NamesThePlaceInTheSceneAndKeepsTheOldPicture()
    {
        using TestFolder folder = new();
        File.WriteAllBytes(folder["a.png"], s_old);
        new Picture(8, 8).Save(folder["texture.png"]);
        byte[] texture = File.ReadAllBytes(folder["texture.png"]);
        texture[^20] ^= 0x40;
        File.WriteAllBytes(folder["texture.png"], texture);
        const string Scene = """
            {
              "textures": { "broken": { "type": "image", "file": "texture.png" } },
              "objects": [ { "shape": "sphere", "material": { "diffuse": "broken" } } ]
            }
            """;
        File.WriteAllText(folder["scene.json"], Scene);
        ProgramRun run = ProgramRun.Of("render", folder["scene.json"], "-o", folder["a.png"]);
        Assert.Equal(ExitCode.BadInput, run.Code);
        Assert.Contains("scene.json:2:", run.Error, StringComparison.Ordinal);
        Assert.Contains("texture.png", run.Error, StringComparison.Ordinal);
        Assert.DoesNotContain("   at ", run.Error, StringComparison.Ordinal);
        Assert.Equal(s_old, File.ReadAllBytes(folder["a.png"]));
        Assert.Equal(["a.png", "scene.json", "texture.png"], folder.Files);
    }

    [Fact]
    public void Render_Cancelled_KeepsTheOldPicture()
    {
        using TestFolder folder = new();
        File.WriteAllBytes(folder["a.png"], s_old);
        using CancellationTokenSource stop = new();
        stop.Cancel();
        ProgramRun run = ProgramRun.Of(stop.Token, "render", ProgramRun.WriteScene(folder), "-o", folder["a.png"]);
        Assert.Equal(ExitCode.Cancelled, run.Code);
        Assert.Contains("cancelled", run.Error, StringComparison.Ordinal);
        Assert.Equal(s_old, File.ReadAllBytes(folder["a.png"]));
        Assert.Equal(["a.png", "small.json"], folder.Files);
    }

    [Fact]
    public void Save_StoppedWhileWriting_KeepsTheOldPictureAndTidiesUp()
    {
        using TestFolder folder = new();
        File.WriteAllBytes(folder["a.png"], s_old);
        using CancellationTokenSource stop = new();
        stop.Cancel();
        Assert.Throws<OperationCanceledException>(() => PictureOutput.Save(new Picture(8, 8), folder["a.png"], PictureSaveOptions.Default, stop.Token));
        using MemoryStream file = new();
        using StoppableStream stream = new(file, stop.Token);
        Assert.Throws<OperationCanceledException>(() => stream.Write([1], 0, 1));
        Assert.Equal(s_old, File.ReadAllBytes(folder["a.png"]));
        Assert.Equal(["a.png"], folder.Files);
    }

    [Fact]
    public void Render_CancelledHalfWay_StopsSoon()
    {
        using TestFolder folder = new();
        using CancellationTokenSource stop = new(TimeSpan.FromMilliseconds(100));
        long start = Environment.TickCount64;
        ProgramRun run = ProgramRun.Of(stop.Token, "render", ProgramRun.WriteScene(folder), "-o", folder["a.png"], "--size", "8000x8000", "--samples", "1024");
        Assert.Equal(ExitCode.Cancelled, run.Code);

        // Not cancelled, this render takes many minutes.
        Assert.InRange(Environment.TickCount64 - start, 0, 20_000);
    }
}
