using RenderScene;

namespace LabRaytracer.Tests.Samples;

public sealed class BenchDataTests
{
    [Fact]
    public void Render_BenchSceneWithoutData_NamesTheCommand()
    {
        using TestFolder folder = new();
        string scene = CopyScene(folder, "s1");
        ProgramRun run = ProgramRun.Of("render", scene, "-o", folder["a.png"]);
        Assert.Equal(ExitCode.BadInput, run.Code);
        Assert.Contains("bench-data", run.Error, StringComparison.Ordinal);
        Assert.Contains("tex0.png", run.Error, StringComparison.Ordinal);
    }

    [Fact]
    public void BenchData_Reduced_MakesAllScenesRender()
    {
        using TestFolder folder = new();
        ProgramRun made = ProgramRun.Of("bench-data", Path.Combine(folder["bench"], "data"), "--reduce", "16");
        Assert.Equal(ExitCode.Done, made.Code);
        foreach (string name in (string[])["s1", "s2", "s3", "s4", "s5"])
        {
            ProgramRun run = ProgramRun.Of("render", CopyScene(folder, name), "-o", folder["a.png"], "--size", "48x27", "--quiet");
            Assert.Equal(new ProgramRun(ExitCode.Done, "", ""), run);
        }
    }

    [Fact]
    public void BenchData_Twice_GivesTheSameBytes()
    {
        using TestFolder folder = new();
        ProgramRun.Of("bench-data", folder["a"], "--reduce", "16");
        ProgramRun.Of("bench-data", folder["b"], "--reduce", "16");
        foreach (string name in (string[])["tex0.png", "tex7.png", "checker_fine.png", "torus.obj"])
        {
            Assert.Equal(File.ReadAllBytes(Path.Combine(folder["a"], name)), File.ReadAllBytes(Path.Combine(folder["b"], name)));
        }
    }

    [Fact]
    public void Torus_SmallOne_HasTheStatedCounts()
    {
        using MemoryStream stream = new();
        new BenchTorus(10, 5).Write(stream);
        string[] lines = System.Text.Encoding.ASCII.GetString(stream.ToArray()).Split('\n');
        Assert.Equal(66, lines.Count(line => line.StartsWith("v ", StringComparison.Ordinal)));
        Assert.Equal(66, lines.Count(line => line.StartsWith("vt ", StringComparison.Ordinal)));
        Assert.Equal(66, lines.Count(line => line.StartsWith("vn ", StringComparison.Ordinal)));
        Assert.Equal(100, lines.Count(line => line.StartsWith("f ", StringComparison.Ordinal)));
    }

    [Fact]
    public void Checker_OfOneTile_HasBlackTopLeftAndSharpEdges()
    {
        Picture picture = BenchPictures.Checker(64, 8);
        Assert.Equal((Intensity.Black, Intensity.White, Intensity.White, Intensity.Black), (picture[7, 7], picture[8, 7], picture[7, 8], picture[8, 8]));
    }

    private static string CopyScene(TestFolder folder, string name)
    {
        Directory.CreateDirectory(folder["bench"]);
        string copy = Path.Combine(folder["bench"], $"{name}.json");
        File.Copy(SampleScenes.File($"bench/{name}.json"), copy);
        return copy;
    }
}
