using System.Diagnostics;
using System.Globalization;
using System.Text;
using System.Text.Json;
using System.Text.Json.Nodes;

namespace LabRaytracer.Validation;

/// <summary>All lines of the error table.</summary>
/// <param name="Options">What was measured.</param>
/// <param name="Rows">The lines, in the order of the sweeps.</param>
/// <param name="Seconds">How long it took.</param>
internal sealed record StressReport(StressOptions Options, IReadOnlyList<StressRow> Rows, double Seconds)
{
    private static readonly JsonSerializerOptions s_json = new() { WriteIndented = true };

    /// <summary>True if every bound holds.</summary>
    public bool IsKept => Rows.All(row => row.IsKept);

    /// <summary>Runs all sweeps.</summary>
    /// <param name="options">What to measure.</param>
    /// <param name="done">Called with each line as soon as it is known.</param>
    public static StressReport Measure(StressOptions options, Action<StressRow>? done = null)
    {
        Stopwatch clock = Stopwatch.StartNew();
        List<StressRow> rows = [];
        foreach (StressRow row in Sweeps(options).SelectMany(sweep => sweep()))
        {
            rows.Add(row);
            done?.Invoke(row);
        }

        return new StressReport(options, rows, clock.Elapsed.TotalSeconds);
    }

    /// <summary>One line of text; a broken bound names its input.</summary>
    public static string Line(StressRow row)
    {
        string line = string.Create(CultureInfo.InvariantCulture, $"{row.Feature,-62} {row.Rows,11} {row.WorstText,10}  {row.BoundText,-12} {row.Verdict}");
        return row.IsKept ? line : $"{line}\n    {row.Example}";
    }

    /// <summary>The last line of the text form.</summary>
    public string Summary() => string.Create(
        CultureInfo.InvariantCulture,
        $"{Rows.Count} features, {Rows.Sum(row => row.Rows)} rows, {Rows.Count(row => !row.IsKept)} broken bounds, {Seconds:0.0} s, seed {Options.Seed}\n");

    /// <summary>The table as JSON.</summary>
    public string ToJson() => new JsonObject
    {
        ["seed"] = Options.Seed,
        ["form"] = Options.IsLong ? "long" : "short",
        ["seconds"] = Math.Round(Seconds, 1),
        ["rows"] = new JsonArray([.. Rows.Select(row => new JsonObject
        {
            ["feature"] = row.Feature,
            ["rows"] = row.Rows,
            ["worst"] = double.IsFinite(row.Worst) ? row.Worst : double.MaxValue,
            ["bound"] = row.Bound,
            ["unit"] = row.Unit,
            ["verdict"] = row.Verdict,
            ["example"] = row.Example,
        })]),
    }.ToJsonString(s_json) + "\n";

    /// <summary>The table in Markdown, for the README.</summary>
    public string ToMarkdown()
    {
        StringBuilder text = new(Options.IsLong ? Summary() + "\n" : "");
        text.Append("| feature | rows | worst error | bound | verdict |\n|---|---|---|---|---|\n");
        foreach (StressRow row in Rows)
        {
            text.Append(CultureInfo.InvariantCulture, $"| {row.Feature} | {row.Rows} | {row.WorstText} | {row.BoundText} | {row.Verdict} |\n");
        }

        return text.ToString();
    }

    private static IEnumerable<Func<IEnumerable<StressRow>>> Sweeps(StressOptions options) =>
    [
        new MappingSweep(options).Run,
        new FurtherMappingSweep(options).Run,
        new FunctionSweep(options).Run,
        new TexelSweep(options).Run,
        new ColorSweep(options).Run,
        new RaySweep(options).Run,
        new TriangleSweep(options).Run,
        new MeetingSweep(options).Run,
        new EndToEndSweep(options).Run,
    ];
}
