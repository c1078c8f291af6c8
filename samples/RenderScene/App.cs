using System.CommandLine;
using System.CommandLine.Help;

namespace RenderScene;

/// <summary>The command line: its verbs, and what becomes of failures.</summary>
internal static class App
{
    /// <summary>Runs one command line.</summary>
    /// <param name="arguments">The words after the program's name.</param>
    /// <param name="console">Where results and messages go.</param>
    /// <param name="stop">Stops what is running; the command then ends with <see cref="ExitCode.Cancelled"/>.</param>
    /// <returns>An <see cref="ExitCode"/>.</returns>
    public static int Run(IReadOnlyList<string> arguments, AppConsole console, CancellationToken stop)
    {
        try
        {
            ParseResult parsed = CreateRoot(console, stop).Parse(arguments, new ParserConfiguration { ResponseFileTokenReplacer = null });
            CommandLineCheck.Check(parsed);
            return parsed.Invoke(new InvocationConfiguration
            {
                Output = console.Output, Error = console.Error, EnableDefaultExceptionHandler = false, ProcessTerminationTimeout = null,
            });
        }
        catch (Exception failure)
        {
            return FailureReport.Write(failure, console.Error);
        }
    }

    private static RootCommand CreateRoot(AppConsole console, CancellationToken stop)
    {
        RootCommand root = new("Renders textured scenes. Without a verb: renders the lab's own scene and the earth into the folder 'out'.")
        {
            RenderVerb.Create(console, stop),
            CompareVerb.Create(console),
            CheckVerb.Create(console),
            BakeVerb.Create(console, stop),
            FigureVerb.Create(console, stop),
            ListVerb.Create(console),
            SchemaVerb.Create(console),
            BenchDataVerb.Create(console, stop),
            DrawTexturesVerb.Create(console),
            FrontierVerb.Create(console, stop),
            StressVerb.Create(console, stop),
            VersionVerb.Create(console),
        };
        foreach (Option option in root.Options.Where(option => option is not HelpOption).ToArray())
        {
            root.Options.Remove(option);
        }

        root.Directives.Clear();
        root.SetAction(_ => WelcomeVerb.Run(console, stop));
        return root;
    }
}
