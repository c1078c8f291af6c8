using RenderScene;

namespace LabRaytracer.Tests.Samples;

/// <summary>What check finds, and that it finds nothing else.</summary>
public sealed class CheckVerbTests
{
    [Fact]
    public void Check_ScenesOfTheFolder_HasNothingToSay()
    {
        foreach (string name in new[] { "06-earth.json", "21-opacity.json", "22-bump.json", "24-occlusion-light-map.json", "50-wraps.json" })
        {
            Assert.Equal(new ProgramRun(ExitCode.Done, "nothing found\n", ""), ProgramRun.Of("check", SampleScenes.File(name)));
        }
    }

    [Theory]
    [InlineData("""{ "diffuse": "wide" }""", "", "diffuse of a material without a name: 8 x 2 texels on a sphere, where 2:1 fits; it is stretched, which costs nothing but may look odd.")]
    [InlineData("""{ "diffuse": "open" }""", "", "diffuse of a material without a name: its left and right edges differ by 191 codes, neighbours inside by at most 13: a seam will show; use a picture that closes.")]
    [InlineData("""{ "bump": "s" }""", "", "bump of a material without a name: data is decoded as sRGB, which bends its numbers; leave colorSpace out, or say linear.")]
    [InlineData("""{ "diffuse": "l" }""", "", "diffuse of a material without a name: a colour is read as linear; leave colorSpace out unless the file's numbers are linear light.")]
    [InlineData("""{ "diffuse": { "texture": "c", "transform": { "scale": [1, 2] } } }""", "", "diffuse of a material without a name: its transform leads outside [0, 1] in v, where the edge texels are drawn out; say wrapV repeat, mirror or border.")]
    [InlineData("""{ "bump": "n" }""", "", "bump of a material without a name: it looks like a normal map, but is read as heights; say normalMap.")]
    [InlineData("""{ "normalMap": "c" }""", "", "normalMap of a material without a name: it does not look like a normal map, which is blue; say bump if it has heights, rebuildZ if it has two channels.")]
    [InlineData("""{ "normalMap": "n" }""", null, null)]
    [InlineData("""{ "normalMap": "d" }""", "", "normalMap of a material without a name: its normals are those of a surface with green down (DirectX), but are read as green up; say flipGreen.")]
    [InlineData("""{ "normalMap": { "texture": "d", "flipGreen": true } }""", null, null)]
    [InlineData("""{ "normalMap": { "texture": "n", "flipGreen": true } }""", "", "normalMap of a material without a name: its normals are those of a surface with green up, but are read as green down; leave flipGreen out.")]
    [InlineData("""{ "opacity": { "texture": "c", "channel": "alpha" } }""", "", "opacity of a material without a name: its alpha is read, which is 1 everywhere; say another channel.")]
    [InlineData("""{ "opacity": "a" }""", "", "opacity of a material without a name: the picture has alpha, but its luminance is read; say channel alpha if that is meant.")]
    [InlineData("""{ "diffuse": { "texture": "c", "layers": [{ "texture": "c", "place": { "center": [0.5, 0.5], "size": [0.25, 0.25] } }] }, "opacity": { "texture": "a", "channel": "alpha" } }""", null, null)]
    public void Check_OneThing_IsOneLine(string material, string? place, string? expected)
    {
        using TestFolder folder = new();
        Draw(folder);
        string path = folder["s.json"];
        File.WriteAllText(path, Scene(material));
        ProgramRun run = ProgramRun.Of("check", path);
        Assert.Equal((expected is null ? ExitCode.Done : ExitCode.CheckFailed, ""), (run.Code, run.Error));
        string[] lines = run.Output.Split('\n', StringSplitOptions.RemoveEmptyEntries);
        Assert.Equal(expected is null ? ["nothing found"] : [expected, "1 finding"], lines.Select(line => line[(line.IndexOf(": ", StringComparison.Ordinal) is int at and > 0 ? at + 2 : 0)..]));
        Assert.True(place is null || lines[0].StartsWith(path + ":3:", StringComparison.Ordinal), lines[0]);
    }

    /// <summary>Primaries of Adobe RGB (1998), whose green lies at (0.21, 0.71): said once, and not where the scene chooses by itself.</summary>
    [Theory]
    [InlineData("", 2)]
    [InlineData(""", "colorSpace": "srgb" """, 1)]
    public void Check_ForeignPrimaries_AreNamed(string choice, int lines)
    {
        using TestFolder folder = new();
        TestPng png = new() { Width = 4, Height = 2, Type = 2, Depth = 8, Sample = (_, _, _) => 99 };
        png.Chunks.Add(("cHRM", [.. new[] { 31270, 32900, 64000, 33000, 21000, 71000, 15000, 6000 }.SelectMany(number => new[] { (byte)(number >> 24), (byte)(number >> 16), (byte)(number >> 8), (byte)number })]));
        File.WriteAllBytes(folder["a.png"], png.ToBytes());
        File.WriteAllText(folder["s.json"], """{ "objects": [{ "shape": "sphere", "material": { "diffuse": { "texture": { "type": "image", "file": "a.png" CHOICE } } } }] }""".Replace("CHOICE", choice, StringComparison.Ordinal));
        ProgramRun run = ProgramRun.Of("check", folder["s.json"]);
        Assert.Equal(lines, run.Output.Split('\n', StringSplitOptions.RemoveEmptyEntries).Length);
        Assert.Equal(lines == 2, run.Output.Contains("its colours may be off: assumed; the cHRM chunk's primaries are not those of sRGB and not converted; save it as sRGB, or say colorSpace", StringComparison.Ordinal));
    }

    private static string Scene(string material) => $$"""
        {
          "textures": {
            {{string.Join(", ", "wide,open,c,n,d,a".Split(',').Select(name => $"\"{name}\": {{ \"type\": \"image\", \"file\": \"{name}.png\" }}"))}}, "s": { "type": "image", "file": "c.png", "colorSpace": "srgb" }, "l": { "type": "image", "file": "c.png", "colorSpace": "linear" }
          },
          "objects": [{ "shape": "sphere", "material": {{material}} }]
        }
        """;

    /// <summary>c: grey and closed; wide: 8 x 2; open: a ramp; n: normals of a bump with green up; d: down; a: with alpha.</summary>
    private static void Draw(TestFolder folder)
    {
        PictureSaveOptions linear = new() { Encoding = TransferFunction.Linear };
        void Save(string name, int width, int height, Func<int, int, Intensity> color)
        {
            Picture picture = new(width, height);
            for (int i = 0; i < width * height; i++)
            {
                picture.Pixels[i] = color(i % width, i / width);
            }

            picture.Save(folder[name], linear);
        }

        Save("c.png", 32, 16, (x, y) => Intensity.Grey(x is > 12 and < 20 && y > 8 ? 0.6f : 0.5f));
        Save("wide.png", 8, 2, (_, _) => Intensity.Grey(0.5f));
        Save("open.png", 16, 8, (x, _) => Intensity.Grey(x * 0.05f));
        Save("n.png", 32, 16, (x, y) => Normal(x, y, 1));
        Save("d.png", 32, 16, (x, y) => Normal(x, y, -1));
        File.WriteAllBytes(folder["a.png"], RgbaPng.Encode(32, 16, (x, y) => (Intensity.White, (x + y) % 2)));
    }

    /// <summary>A round hill in the middle; rows go down.</summary>
    private static Intensity Normal(int x, int y, float green)
    {
        float dx = (x - 15.5f) / 8, dy = (7.5f - y) / 8, fall = MathF.Exp(-2 * ((dx * dx) + (dy * dy)));
        float nx = 2 * dx * fall, ny = 2 * dy * fall * green, length = MathF.Sqrt((nx * nx) + (ny * ny) + 1);
        return new Intensity((1 + (nx / length)) / 2, (1 + (ny / length)) / 2, (1 + (1 / length)) / 2);
    }
}
