using System.Globalization;

namespace LabRaytracer.Validation;

/// <summary>The command line of the sweep.</summary>
internal static class StressCommand
{
    /// <summary>Runs the sweep and prints its table.</summary>
    /// <returns>0: every bound holds; 1: one is broken; 2: an option is wrong.</returns>
    public static int Run(IReadOnlyList<string> arguments, TextWriter output, TextWriter error)
    {
        ulong seed = StressOptions.DefaultSeed;
        bool isLong = false, isJson = false;
        for (int i = 0; i < arguments.Count; i++)
        {
            switch (arguments[i])
            {
                case "--long":
                    isLong = true;
                    break;
                case "--json":
                    isJson = true;
                    break;
                case "--seed" when i + 1 < arguments.Count && ulong.TryParse(arguments[i + 1], NumberStyles.None, CultureInfo.InvariantCulture, out seed):
                    i++;
                    break;
                default:
                    error.WriteLine($"error: '{arguments[i]}' is not understood. Allowed: --seed N (a whole number of at least 0), --long, --json.");
                    return 2;
            }
        }

        return Report(new StressOptions(seed, isLong), isJson, output, error).IsKept ? 0 : 1;
    }

    /// <summary>Runs the sweep and prints its table, or JSON.</summary>
    public static StressReport Report(StressOptions options, bool isJson, TextWriter output, TextWriter error)
    {
        error.WriteLine(FormattableString.Invariant($"seed {options.Seed}, {(options.IsLong ? "long" : "short")} form"));
        StressReport report = StressReport.Measure(options, isJson ? null : row => output.WriteLine(StressReport.Line(row)));
        output.Write(isJson ? report.ToJson() : report.Summary());
        return report;
    }
}
