using System.Text;
using System.Text.Json;
using RenderScene;

namespace LabRaytracer.Tests.Samples;

public sealed class RenderVerbTests
{
    [Fact]
    public void Render_SmallScene_WritesThePictureAndSaysSo()
    {
        using TestFolder folder = new();
        string picture = folder["ball.png"];
        ProgramRun run = ProgramRun.Of("render", ProgramRun.WriteScene(folder), "-o", picture);
        Assert.Equal((ExitCode.Done, true), (run.Code, run.Output.Contains("32 x 18", StringComparison.Ordinal)));
        Picture read = Picture.Load(picture);
        Assert.Equal((32, 18), (read.Width, read.Height));
        Assert.True(read[16, 9].R > 0.3f);
    }

    [Fact]
    public void Render_InAPipe_ReportsALineForEveryTenPercentAtMost()
    {
        using TestFolder folder = new();
        ProgramRun run = ProgramRun.Of("render", ProgramRun.WriteScene(folder), "-o", folder["a.png"], "--size", "640x360");
        string[] lines = run.Error.Split('\n', StringSplitOptions.RemoveEmptyEntries);
        Assert.InRange(lines.Length, 1, 10);
        Assert.Equal("small.json: 100 %", lines[^1]);
        Assert.DoesNotContain('\u001b', run.Error);
        Assert.DoesNotContain('\r', run.Error);
    }

    [Fact]
    public void Render_Quiet_SaysNothing()
    {
        using TestFolder folder = new();
        Assert.Equal(new ProgramRun(ExitCode.Done, "", ""), ProgramRun.Of("render", ProgramRun.WriteScene(folder), "-o", folder["a.png"], "--quiet"));
    }

    [Fact]
    public void Render_AllOptions_AreObeyed()
    {
        using TestFolder folder = new();
        ProgramRun run = ProgramRun.Of(
            "render", ProgramRun.WriteScene(folder), "-o", folder["a.png"], "--size", "64x36", "--samples", "4", "--pattern", "jittered", "--seed", "-7", "--threads", "1",
            "--precision", "float", "--filter", "nearest", "--crop", "8,4,20,10", "--view", "normal", "--stats", "--stats-json", folder["a.json"], "--quiet");
        Assert.Equal((ExitCode.Done, ""), (run.Code, run.Error));
        Assert.Contains("rays from the camera", run.Output, StringComparison.Ordinal);
        Picture picture = Picture.Load(folder["a.png"]);
        Assert.Equal((20, 10), (picture.Width, picture.Height));
        using JsonDocument json = JsonDocument.Parse(File.ReadAllText(folder["a.json"]));
        Assert.Equal(20 * 10 * 4, json.RootElement.GetProperty("primaryRays").GetInt64());
        Assert.Equal("float", json.RootElement.GetProperty("precision").GetString());
    }

    [Fact]
    public void Render_CommaCulture_GivesTheSameBytesAndPoints()
    {
        using TestFolder folder = new();
        string scene = ProgramRun.WriteScene(folder);
        ProgramRun.Of("render", scene, "-o", folder["a.png"], "--threads", "2");
        ProgramRun run;
        using (new CommaCulture())
        {
            run = ProgramRun.Of("render", scene, "-o", folder["b.png"], "--threads", "1", "--stats");
        }

        Assert.Equal(File.ReadAllBytes(folder["a.png"]), File.ReadAllBytes(folder["b.png"]));
        Assert.DoesNotContain("0,", run.Output, StringComparison.Ordinal);
    }

    [Fact]
    public void Render_Picture_SaysHowItWasMade()
    {
        using TestFolder folder = new();
        ProgramRun.Of("render", ProgramRun.WriteScene(folder), "-o", folder["a.png"]);
        string bytes = Encoding.Latin1.GetString(File.ReadAllBytes(folder["a.png"]));
        Assert.Contains("small", bytes, StringComparison.Ordinal);
        Assert.Contains("--size 32x18 --samples 1", bytes, StringComparison.Ordinal);
        Assert.Contains($"LabRaytracer {VersionVerb.Version}", bytes, StringComparison.Ordinal);
    }

    [Theory]
    [InlineData("--size", "1280", "WxH")]
    [InlineData("--size", "0x5", "1 to 1048576")]
    [InlineData("--size", "1048576x1048576", "at most")]
    [InlineData("--samples", "5", "4 and 9")]
    [InlineData("--budget", "-1", "at least 0")]
    [InlineData("--budget", "1001", "0 to 1000")]
    [InlineData("--edge-samples", "0", "1 to 65536")]
    [InlineData("--max-samples", "3", "4 to 65536")]
    [InlineData("--pixel-filter", "mitchel", "did you mean 'mitchell'")]
    [InlineData("--samples", "many", "1 to 65536")]
    [InlineData("--threads", "0", "1 to 1024")]
    [InlineData("--precision", "doubble", "did you mean 'double'")]
    [InlineData("--filter", "blurred", "nearest, bilinear")]
    [InlineData("--view", "norml", "did you mean 'normal'")]
    [InlineData("--tone-mapping", "reinhart", "did you mean 'reinhard'")]
    [InlineData("--dither", "blue", "none, ordered, bluenoise")]
    [InlineData("--exposure", "65", "from -64 to 64")]
    [InlineData("--exposure", "dark", "from -64 to 64")]
    [InlineData("--crop", "0,0,33,1", "inside")]
    [InlineData("--crop", "0,0", "X,Y,W,H")]
    [InlineData("--seed", "1.5", "whole number")]
    [InlineData("--sampels", "4", "did you mean '--samples'")]
    [InlineData("-o", "a.gif", ".png")]
    public void Render_BadOption_IsRefusedWithWhatIsAllowed(string option, string value, string allowed)
    {
        using TestFolder folder = new();
        ProgramRun run = ProgramRun.Of("render", ProgramRun.WriteScene(folder), option, value);
        Assert.Equal(ExitCode.Usage, run.Code);
        Assert.Contains(allowed, run.Error, StringComparison.Ordinal);
        Assert.Equal(["small.json"], folder.Files);
        Assert.Single(run.Error.TrimEnd('\n').Split('\n'));
    }

    /// <summary>Exposure, tone mapping and dither of the command line take the place of the scene's, and the file says so.</summary>
    [Fact]
    public void Render_OutputOptions_TakeThePlaceOfTheScenes()
    {
        using TestFolder folder = new();
        File.WriteAllText(folder["s.json"], """{ "render": { "width": 16, "height": 16 }, "output": { "exposureStops": 3, "toneMapping": "aces" }, "background": 3 }""");
        byte Code(params string[] options)
        {
            ProgramRun run = ProgramRun.Of(["render", folder["s.json"], "-o", folder["a.png"], "--quiet", .. options]);
            Assert.Equal(new ProgramRun(ExitCode.Done, "", ""), run);
            return PictureCodecs.Default.Read(folder["a.png"]).Rgba8![0];
        }

        // 3 x 2^-2 = 0.75 clamped; Reinhard: 0.75 / 1.75 = 0.428571, sRGB code 175 (0.685), clamped: sRGB code 225 (0.8808).
        Assert.Equal(225, Code("--exposure", "-2", "--tone-mapping", "clamp"));
        Assert.Equal(175, Code("--exposure", "-2", "--tone-mapping", "Reinhard"));
        Code("--exposure", "-2.5", "--tone-mapping", "clamp", "--dither", "blueNoise");
        byte[] dithered = PictureCodecs.Default.Read(folder["a.png"]).Rgba8!;
        Assert.Equal(2, dithered.Where((_, i) => i % 4 == 0).Distinct().Count());
        Assert.Contains("--exposure -2.5 --dither bluenoise", Encoding.Latin1.GetString(File.ReadAllBytes(folder["a.png"])), StringComparison.Ordinal);
    }

    /// <summary>Missing and damaged pictures are errors with their place; with --allow-missing a checker of magenta and black stands in, and a warning names the place.</summary>
    [Fact]
    public void Render_MissingAndDamagedPictures_AreErrorsOrCheckersWithAWarning()
    {
        using TestFolder folder = new();
        File.WriteAllText(folder["bad.png"], "no picture");
        string scene = folder["s.json"];
        foreach ((string file, string why) in new[] { ("gone.png", "'gone.png' does not exist"), ("bad.png", "the format is not known") })
        {
            File.WriteAllText(scene, """{ "background": { "texture": { "type": "image", "file": "NAME", "filter": "nearest" } } }""".Replace("NAME", file, StringComparison.Ordinal));
            ProgramRun refused = ProgramRun.Of("render", scene, "-o", folder["a.png"], "--quiet", "--size", "64x64");
            Assert.Equal(ExitCode.BadInput, refused.Code);
            Assert.Contains(why, refused.Error, StringComparison.Ordinal);
            Assert.Single(refused.Error.TrimEnd('\n').Split('\n'));
            ProgramRun allowed = ProgramRun.Of("render", scene, "-o", folder["a.png"], "--quiet", "--size", "64x64", "--allow-missing");
            Assert.Equal((ExitCode.Done, ""), (allowed.Code, allowed.Output));
            Assert.StartsWith("warning: ", allowed.Error, StringComparison.Ordinal);
            Assert.Contains("s.json:1:57: ", allowed.Error, StringComparison.Ordinal);
            Assert.Contains(why, allowed.Error, StringComparison.Ordinal);
            Assert.EndsWith("; a checker stands in\n", allowed.Error, StringComparison.Ordinal);
            Assert.Single(allowed.Error.TrimEnd('\n').Split('\n'));
            HashSet<Intensity> colors = [.. Picture.Load(folder["a.png"]).Pixels];
            Assert.Equal([Intensity.Black, new Intensity(1, 0, 1)], colors.OrderBy(color => color.R));
        }
    }

    [Fact]
    public void Render_Stats_NamesPicturesAndTheRuleOfTheirColors()
    {
        using TestFolder folder = new();
        new Picture(4, 2).Save(folder["a.png"]);
        File.WriteAllText(folder["s.json"], """
            {
              "textures": { "a": { "type": "image", "file": "a.png" }, "b": { "type": "image", "file": "a.png", "colorSpace": "linear" }, "c": { "type": "image", "file": "a.png", "colorSpace": "srgb" } },
              "objects": [ { "shape": "sphere", "material": { "diffuse": "a", "emission": "b" } } ]
            }
            """);
        ProgramRun run = ProgramRun.Of("render", folder["s.json"], "-o", folder["o.png"], "--size", "8x8", "--stats", "--stats-json", folder["o.json"]);
        Assert.Contains("  picture a.png: 4 x 2, 8 bits, colours sRGB (sRGB chunk)\n", run.Output, StringComparison.Ordinal);
        Assert.Contains("  picture a.png: 4 x 2, 8 bits, colours linear (asked for)\n", run.Output, StringComparison.Ordinal);
        using JsonDocument json = JsonDocument.Parse(File.ReadAllText(folder["o.json"]));
        Assert.Equal("sRGB (sRGB chunk)", json.RootElement.GetProperty("pictures")[0].GetProperty("colors").GetString());
    }

    [Theory]
    [InlineData("--sppp", "3")]
    [InlineData("--help-me", "x")]
    public void Render_UnknownOptionBeforeTheScene_IsNotTakenForTheScene(string option, string value)
    {
        ProgramRun run = ProgramRun.Of("render", option, value);
        Assert.Equal(ExitCode.Usage, run.Code);
        Assert.StartsWith($"error: unknown option '{option}'", run.Error, StringComparison.Ordinal);
    }

    [Fact]
    public void Render_WithoutScene_IsAUsageError()
    {
        ProgramRun run = ProgramRun.Of("render");
        Assert.Equal(ExitCode.Usage, run.Code);
        Assert.Contains("render --help", run.Error, StringComparison.Ordinal);
    }

    [Fact]
    public void Render_MissingScene_IsBadInputAndLeavesNoFile()
    {
        using TestFolder folder = new();
        ProgramRun run = ProgramRun.Of("render", folder["none.json"], "-o", folder["a.png"]);
        Assert.Equal(ExitCode.BadInput, run.Code);
        Assert.Contains("none.json", run.Error, StringComparison.Ordinal);
        Assert.Empty(folder.Files);
    }

    [Fact]
    public void Render_BrokenScene_NamesThePlace()
    {
        using TestFolder folder = new();
        File.WriteAllText(folder["bad.json"], "{\n  \"objects\": [ { \"shape\": \"spere\" } ]\n}\n");
        ProgramRun run = ProgramRun.Of("render", folder["bad.json"], "-o", folder["a.png"]);
        Assert.Equal(ExitCode.BadInput, run.Code);
        Assert.Contains("bad.json:2:", run.Error, StringComparison.Ordinal);
        Assert.Equal(["bad.json"], folder.Files);
    }
}
