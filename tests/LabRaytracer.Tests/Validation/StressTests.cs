using System.Text.Json;
using LabRaytracer.Tests.Architecture;
using LabRaytracer.Tests.Samples;

namespace LabRaytracer.Validation.Tests;

/// <summary>The error table of the README and the program that makes it.</summary>
public sealed class StressTests
{
    private static readonly Lazy<ProgramRun> s_run = new(() => ProgramRun.Of("stress", "--json"));

    [Fact]
    public void Readme_FreshRun_SameFeaturesAndVerdicts()
    {
        Dictionary<string, string> committed = MarkedTable.Errors.Lines(SourceTree.Read("README.md")).ToDictionary(line => line[0], line => line[4]);
        using JsonDocument table = JsonDocument.Parse(s_run.Value.Output);
        Dictionary<string, string> fresh = table.RootElement.GetProperty("rows").EnumerateArray()
            .ToDictionary(row => row.GetProperty("feature").GetString()!, row => row.GetProperty("verdict").GetString()!);
        Assert.True(committed.Count > 90);
        Assert.Equal(committed.OrderBy(row => row.Key, StringComparer.Ordinal), fresh.OrderBy(row => row.Key, StringComparer.Ordinal));
    }

    [Fact]
    public void Stress_DefaultSeed_EveryBoundHolds()
    {
        Assert.Equal(0, s_run.Value.Code);
        Assert.DoesNotContain("BREACH", s_run.Value.Output, StringComparison.Ordinal);
        Assert.Contains("20240607", s_run.Value.Error, StringComparison.Ordinal);
    }

    [Theory]
    [InlineData(1, 1, true)]
    [InlineData(1.01, 1, false)]
    [InlineData(double.NaN, 1, false)]
    [InlineData(double.PositiveInfinity, 1, false)]
    public void Worst_AnyError_VerdictFollowsTheBound(double error, double bound, bool isKept)
    {
        Worst worst = new("feature", bound, "ulp");
        worst.Note(error, $"input");
        Assert.Equal(isKept, worst.ToRow().IsKept);
    }

    [Fact]
    public void Worst_NothingMeasured_IsABreach() => Assert.False(new Worst("feature", 1, "ulp").ToRow().IsKept);

    [Fact]
    public void Report_OneBrokenBound_IsNotKeptAndNamesItsInput()
    {
        StressRow broken = new("wrong", 3, 2, 1, "ulp", "the input");
        StressReport report = new(new StressOptions(), [new StressRow("right", 3, 1, 1, "ulp"), broken], 0);
        Assert.False(report.IsKept);
        Assert.Contains("the input", StressReport.Line(broken), StringComparison.Ordinal);
        Assert.Contains("| wrong | 3 | 2 | 1 ulp | BREACH |", report.ToMarkdown(), StringComparison.Ordinal);
    }

    [Theory]
    [InlineData("--seed", "-1")]
    [InlineData("--seed", "many")]
    public void Stress_WrongSeed_SaysWhatIsAllowed(string option, string value)
    {
        ProgramRun run = ProgramRun.Of("stress", option, value);
        Assert.Equal(2, run.Code);
        Assert.Contains("whole number", run.Error, StringComparison.Ordinal);
    }

    [Fact]
    public void Stress_ReadmeWithoutMarkers_IsRefusedBeforeTheSweep()
    {
        ProgramRun run = ProgramRun.Of("stress", "--readme", "nowhere.md");
        Assert.Equal(3, run.Code);
        Assert.Contains("nowhere.md", run.Error, StringComparison.Ordinal);
    }
}
