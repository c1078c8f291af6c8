using RenderScene;

namespace LabRaytracer.Tests.Samples;

public sealed class OtherVerbTests
{
    [Fact]
    public void Version_Always_PrintsTheLibrarysVersion() =>
        Assert.Equal(new ProgramRun(ExitCode.Done, $"LabRaytracer {typeof(Scene).Assembly.GetName().Version!.ToString(3)}\n", ""), ProgramRun.Of("version"));

    [Fact]
    public void Schema_Always_PrintsTheSchemaAlone() => Assert.Equal(new ProgramRun(ExitCode.Done, SceneSchema.Generate(), ""), ProgramRun.Of("schema"));

    [Fact]
    public void List_Always_NamesScenesAndWords()
    {
        ProgramRun run = ProgramRun.Of("list");
        Assert.Equal((ExitCode.Done, ""), (run.Code, run.Error));
        string[] words = ["06-earth.json", "north up", "bench", "sphere", "mesh", "checker", "grid", "image", "point", "perspective", "rectangular, cylindrical, spherical"];
        Assert.All(words, word => Assert.Contains(word, run.Output, StringComparison.Ordinal));
        Assert.DoesNotContain("schema.json", run.Output, StringComparison.Ordinal);
    }

    [Fact]
    public void Help_Always_NamesAllVerbs()
    {
        ProgramRun run = ProgramRun.Of("--help");
        Assert.Equal(ExitCode.Done, run.Code);
        string[] verbs = ["render", "compare", "figure", "list", "schema", "version", "bench-data"];
        Assert.All(verbs, verb => Assert.Contains(verb, run.Output, StringComparison.Ordinal));
    }

    [Theory]
    [InlineData("rendr", "did you mean 'render'")]
    [InlineData("paint", "allowed: render")]
    [InlineData("scene.json", "render scene.json")]
    [InlineData("--sampels", "unknown option '--sampels'")]
    public void UnknownVerb_Anywhere_IsAUsageErrorWithTheNearestWord(string word, string hint)
    {
        ProgramRun run = ProgramRun.Of(word);
        Assert.Equal(ExitCode.Usage, run.Code);
        Assert.Contains(hint, run.Error, StringComparison.Ordinal);
    }

    [Theory]
    [InlineData("schema", "now")]
    [InlineData("figure", "9")]
    [InlineData("figure", "one")]
    [InlineData("bench-data", "x", "--reduce", "3")]
    [InlineData("render", "")]
    [InlineData("render", "a.json", "b.json")]
    [InlineData("render", "a.json", "--quiet=maybe")]
    [InlineData("render", "a.json", "-o")]
    [InlineData("render", "a.json", "@options")]
    [InlineData("compare", "a.png")]
    [InlineData("[suggest]")]
    public void Verbs_WrongWords_AreUsageErrors(params string[] arguments)
    {
        ProgramRun run = ProgramRun.Of(arguments);
        Assert.Equal(ExitCode.Usage, run.Code);
        Assert.DoesNotContain("System.", run.Error, StringComparison.Ordinal);
    }

    [Fact]
    public void Verbs_FolderInPlaceOfAFile_AreBadInput()
    {
        using TestFolder folder = new();
        Directory.CreateDirectory(folder["a"]);
        File.WriteAllText(folder["b"], "");
        string[][] lines = [["compare", folder["a"], folder["a"]], ["bench-data", folder["b"]], ["draw-textures", folder["b"]], ["render", folder["a"], "-o", folder["x.png"]]];
        Assert.All(lines, line =>
        {
            ProgramRun run = ProgramRun.Of(line);
            Assert.Equal(ExitCode.BadInput, run.Code);
            Assert.Contains("folder", run.Error, StringComparison.Ordinal);
        });
    }

    [Fact]
    public void NoArguments_Cancelled_StopsWithoutAPicture()
    {
        using CancellationTokenSource stop = new();
        stop.Cancel();
        Assert.Equal(ExitCode.Cancelled, ProgramRun.Of(stop.Token).Code);
    }

    [Theory]
    [InlineData(1)]
    [InlineData(2)]
    [InlineData(3)]
    [InlineData(4)]
    [InlineData(5)]
    [InlineData(6)]
    [InlineData(7)]
    [InlineData(8)]
    public void Figure_OfTheSheet_IsDrawn(int number)
    {
        using TestFolder folder = new();
        ProgramRun run = ProgramRun.Of("figure", $"{number}", "-o", folder["figure.png"], "--width", "320", "--quiet");
        Assert.Equal(new ProgramRun(ExitCode.Done, "", ""), run);
        Picture picture = Picture.Load(folder["figure.png"]);
        Assert.Equal(320, picture.Width);
        HashSet<Intensity> colors = [.. picture.Pixels];
        Assert.True(colors.Count > 40, $"figure {number} has {colors.Count} colours only");
    }

    [Fact]
    public void DrawTextures_Always_GivesTheBytesInTheScenesFolder()
    {
        using TestFolder folder = new();
        string[] small = ["test-8x4.png", "crate.png"];
        foreach (string name in small)
        {
            TexturePictures.All[name]().Save(folder[name]);
            Assert.Equal(Picture.Load(SampleScenes.File($"textures/{name}")).Pixels, Picture.Load(folder[name]).Pixels);
        }
    }
}
