using RenderScene;

namespace LabRaytracer.Tests.Samples;

public sealed class BakeVerbTests
{
    private const string Scene = """
        {
          "textures": {
            "ramp": { "type": "gradient", "along": "v" },
            "north": { "type": "gradient", "along": "axis", "ramp": [{ "at": -1, "color": 0 }, { "at": 1, "color": 1 }] }
          }
        }
        """;

    /// <summary>Row 0 is on top, where v = 7.5/8; between texel centres a gradient is what bilinear lookup makes of it, but for the half texels at both ends, which repeat.</summary>
    [Fact]
    public void Bake_Gradient_WritesTexelCentresAndItsError()
    {
        using TestFolder folder = new();
        File.WriteAllText(folder["s.json"], Scene);
        ProgramRun run = ProgramRun.Of("bake", folder["s.json"], "ramp", "-o", folder["a.pfm"], "--size", "4x8");
        Assert.Equal((ExitCode.Done, ""), (run.Code, run.Error));

        // Of 16 rows of places the first and the last are 0.25 texels beyond the outer centres: the lookup mixes a quarter of the other end in, 7/8 away, and the
        // gradient moves on by 1/32. (7/32 + 1/32) = 0.25 at most; root of (2/16 0.25²) = 0.088388.
        Assert.Contains("4 x 8 texels; their bilinear lookup differs by 0.088388 root mean square, 0.250000 at most", run.Output, StringComparison.Ordinal);
        Picture picture = Picture.Load(folder["a.pfm"]);
        Assert.Equal((Intensity.Grey(7.5f / 8), Intensity.Grey(0.5f / 8)), (picture[1, 0], picture[3, 7]));
    }

    /// <summary>Over a sphere the height of row y of 4 is cos(theta) = cos(pi (y + 1/2) / 4): (1 + 0.923880) / 2 on top.</summary>
    [Fact]
    public void Bake_OverASphere_ReadsPointsOfTheSphere()
    {
        using TestFolder folder = new();
        File.WriteAllText(folder["s.json"], Scene);
        Assert.Equal(ExitCode.Done, ProgramRun.Of("bake", folder["s.json"], "north", "-o", folder["a.pfm"], "--size", "8x4", "--surface", "sphere").Code);
        Picture picture = Picture.Load(folder["a.pfm"]);
        Assert.Equal(0.96193977, picture[5, 0].G, 1e-6);
        Assert.Equal(0.03806023, picture[5, 3].G, 1e-6);
    }

    [Theory]
    [InlineData("rmap", "4x4", "plane", "did you mean 'ramp'; allowed: ramp, north")]
    [InlineData("ramp", "0x4", "plane", "at least 1 texel a side")]
    [InlineData("ramp", "99999x99999", "plane", "at most 67108864")]
    [InlineData("ramp", "4x4", "ball", "plane, rectangle, cylinder, sphere")]
    public void Bake_BadWords_AreRefusedInOneLine(string texture, string size, string surface, string allowed)
    {
        using TestFolder folder = new();
        File.WriteAllText(folder["s.json"], Scene);
        ProgramRun run = ProgramRun.Of("bake", folder["s.json"], texture, "-o", folder["a.png"], "--size", size, "--surface", surface);
        Assert.Equal(ExitCode.Usage, run.Code);
        Assert.Contains(allowed, run.Error, StringComparison.Ordinal);
        Assert.Single(run.Error.TrimEnd('\n').Split('\n'));
        Assert.Equal(["s.json"], folder.Files);
    }
}
