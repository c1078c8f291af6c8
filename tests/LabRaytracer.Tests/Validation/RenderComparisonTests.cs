using LabRaytracer.Tests.Architecture;

namespace LabRaytracer.Validation.Tests;

/// <summary>Whole renders in each precision, and their table in the README.</summary>
public sealed class RenderComparisonTests
{
    public static TheoryData<string> StressScenes => [.. Directory.GetFiles(Path.Combine(SourceTree.Root, "scenes", "stress"), "*.json").Order(StringComparer.Ordinal)];

    [Theory]
    [MemberData(nameof(StressScenes))]
    public void StressScene_DoubleLanes_NoPixelIsWrong(string path)
    {
        Scene scene = SceneFile.Load(path).Scene;
        Picture exact = Renderer.Render(scene, Small(Precision.Exact)).Picture, usual = Renderer.Render(scene, Small(Precision.Double)).Picture;
        Assert.Equal(0, RenderComparison.Wrong(usual, exact));
        Assert.True(PictureDifference.Compare(usual, exact).Max < 1e-6);
        Assert.True(RenderComparison.Wrong(Renderer.Render(scene, Small(Precision.Single)).Picture, exact) is > 0 and < 0.2);
    }

    [Fact]
    public void Readme_TableOfRenders_HasAllScenesAndNoWrongPixelInDouble()
    {
        IReadOnlyList<string[]> lines = MarkedTable.Renders.Lines(SourceTree.Read("README.md"));
        Assert.Equal(9, lines.Count);
        Assert.All(lines, line =>
        {
            Assert.True(File.Exists(Path.Combine(SourceTree.Root, "scenes", line[0] + ".json")), $"There is no scene '{line[0]}'.");
            Assert.Equal("0", line[6]);
        });
    }

    [Theory]
    [InlineData(1, 1, 0)]
    [InlineData(1, 0.994f, 0)]
    [InlineData(1, 0.98f, 1)]
    public void Wrong_ComponentOffByMoreThanOneCode_Counts(float a, float b, double expected)
    {
        Picture first = new(1, 1), second = new(1, 1);
        (first[0, 0], second[0, 0]) = (new Intensity(0, a, 0), new Intensity(0, b, 0));
        Assert.Equal(expected, RenderComparison.Wrong(first, second));
    }

    private static RenderOptions Small(Precision precision) => new() { Width = 240, Height = 135, Threads = 1, Precision = precision };
}
