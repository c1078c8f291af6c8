using LabRaytracer.Tests.Architecture;

namespace LabRaytracer.Tests.Samples;

/// <summary>The figures of the sheet against the stored ones, which somebody looked at.</summary>
public sealed class FigureReferenceTests
{
    [Theory]
    [InlineData(1)]
    [InlineData(2)]
    [InlineData(3)]
    [InlineData(4)]
    [InlineData(5)]
    [InlineData(6)]
    [InlineData(7)]
    [InlineData(8)]
    public void Figure_OfTheSheet_IsTheStoredOne(int number)
    {
        const string Folder = "tests/LabRaytracer.Tests/RenderScene/Figures";
        using TestFolder folder = new();
        Assert.Equal(0, ProgramRun.Of("figure", $"{number}", "-o", folder["figure.png"], "--width", "480", "--quiet").Code);
        Picture stored = Picture.Load(Path.Combine(SourceTree.Root, Folder, $"figure-{number}.png")), drawn = Picture.Load(folder["figure.png"]);
        PictureDifference difference = PictureDifference.Compare(stored, drawn);
        Assert.True(
            difference.Max == 0,
            $"Figure {number} differs from {Folder}/figure-{number}.png by up to {difference.Max} of 1. If that is meant, look at both, then store it: "
            + $"dotnet run -c Release --project samples/RenderScene -- figure {number} --width 480 -o {Folder}/figure-{number}.png");
    }
}
