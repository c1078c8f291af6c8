using System.CommandLine;
using System.Globalization;
using LabRaytracer.Validation;

namespace RenderScene;

/// <summary>stress: every formula against exact arithmetic, worst case by feature.</summary>
internal sealed class StressVerb
{
    private readonly Option<string?> _seed = new("--seed") { HelpName = "N", Description = "Random numbers of the sweep, a whole number from 0. Default: the seed of the committed table." };

    private readonly Option<bool> _long = new("--long") { Description = "The long form: more than 100 million mapping points and 10 million rays, for about a quarter of an hour on two idle cores." };

    private readonly Option<bool> _renders = new("--renders") { Description = "Instead: the bench scenes and the stress scenes as whole renders in float, double and exact mode, time against error." };

    private readonly Option<bool> _json = new("--json") { Description = "The table as JSON." };

    private readonly Option<string?> _readme = new("--readme") { HelpName = "FILE", Description = "Write the table between the error table's markers of this Markdown file." };

    /// <summary>The verb for the command line.</summary>
    public static Command Create(AppConsole console, CancellationToken stop)
    {
        StressVerb verb = new();
        Command command = new("stress", "Compares every formula with exact arithmetic; exits with 1 if a bound is broken.") { verb._seed, verb._long, verb._renders, verb._json, verb._readme };
        command.SetAction(parsed => verb.Run(parsed, console, stop));
        return command;
    }

    private int Run(ParseResult parsed, AppConsole console, CancellationToken stop)
    {
        ulong seed = parsed.GetValue(_seed) is { } text ? Seed(text) : StressOptions.DefaultSeed;
        string? readme = parsed.GetValue(_readme);
        bool isLong = parsed.GetValue(_long);
        MarkedTable place = parsed.GetValue(_renders) ? MarkedTable.Renders : isLong ? MarkedTable.LongForm : MarkedTable.Errors;
        if (readme is not null && !place.IsIn(readme))
        {
            throw new InputException($"'{readme}' is no Markdown file with the lines {place.Start} and {place.End}; add them where the table belongs.");
        }

        if (parsed.GetValue(_renders))
        {
            string table = StressRenders.Measure(console.Output, stop);
            if (readme is not null)
            {
                place.Write(readme, table);
            }

            return ExitCode.Done;
        }

        StressReport report = StressCommand.Report(new StressOptions(seed, isLong), parsed.GetValue(_json), console.Output, console.Error);
        if (readme is not null)
        {
            place.Write(readme, report.ToMarkdown());
        }

        return report.IsKept ? ExitCode.Done : ExitCode.CheckFailed;
    }

    private static ulong Seed(string text) => ulong.TryParse(text, NumberStyles.None, CultureInfo.InvariantCulture, out ulong seed)
        ? seed
        : throw new UsageException($"--seed '{text}' is not a whole number from 0 to {ulong.MaxValue}.");
}
