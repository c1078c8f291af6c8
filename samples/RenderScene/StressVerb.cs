using System.CommandLine;
using System.Globalization;
using LabRaytracer.Validation;

namespace RenderScene;

/// <summary>stress: every formula against exact arithmetic, worst case by feature.</summary>
internal sealed class StressVerb
{
    private readonly Option<string?> _seed = new("--seed") { HelpName = "N", Description = "Random numbers of the sweep, a whole number from 0. Default: the seed of the committed table." };

    private readonly Option<bool> _long = new("--long") { Description = "The long form: more than 100 million mapping points and 10 million rays, for about an hour on two cores." };

    private readonly Option<bool> _json = new("--json") { Description = "The table as JSON." };

    private readonly Option<string?> _readme = new("--readme") { HelpName = "FILE", Description = "Write the table between the error table's markers of this Markdown file." };

    /// <summary>The verb for the command line.</summary>
    public static Command Create(AppConsole console)
    {
        StressVerb verb = new();
        Command command = new("stress", "Compares every formula with exact arithmetic; exits with 1 if a bound is broken.") { verb._seed, verb._long, verb._json, verb._readme };
        command.SetAction(parsed => verb.Run(parsed, console));
        return command;
    }

    private int Run(ParseResult parsed, AppConsole console)
    {
        ulong seed = parsed.GetValue(_seed) is { } text ? Seed(text) : StressOptions.DefaultSeed;
        string? readme = parsed.GetValue(_readme);
        bool isLong = parsed.GetValue(_long);
        if (readme is not null && !ErrorTable.HasMarkers(readme, isLong))
        {
            throw new InputException($"'{readme}' is no Markdown file with the lines {ErrorTable.Start(isLong)} and {ErrorTable.End(isLong)}; add them where the table belongs.");
        }

        StressReport report = StressCommand.Report(new StressOptions(seed, isLong), parsed.GetValue(_json), console.Output, console.Error);
        if (readme is not null)
        {
            ErrorTable.Write(readme, report);
        }

        return report.IsKept ? ExitCode.Done : ExitCode.CheckFailed;
    }

    private static ulong Seed(string text) => ulong.TryParse(text, NumberStyles.None, CultureInfo.InvariantCulture, out ulong seed)
        ? seed
        : throw new UsageException($"--seed '{text}' is not a whole number from 0 to {ulong.MaxValue}.");
}
