using Spectre.Console;

namespace RenderScene;

/// <summary>The terminal that previews are drawn in, or why there is none.</summary>
internal sealed class PreviewScreen
{
    private const string NoTerminal = "the output goes into a pipe or a file, not to a terminal";

    private PreviewScreen(IAnsiConsole? terminal, string? refusal)
    {
        Terminal = terminal;
        Refusal = refusal;
    }

    /// <summary>No terminal at all.</summary>
    public static PreviewScreen None { get; } = new(null, NoTerminal);

    /// <summary>The terminal; null if nothing may be drawn.</summary>
    public IAnsiConsole? Terminal { get; }

    /// <summary>Why nothing may be drawn, a few words; null if it may.</summary>
    public string? Refusal { get; }

    /// <summary>A terminal that shows colours.</summary>
    public static PreviewScreen On(IAnsiConsole terminal) => new(terminal, null);

    /// <summary>The terminal of the process.</summary>
    public static PreviewScreen System()
    {
        string? refusal = FindRefusal(
            Console.IsOutputRedirected, Environment.GetEnvironmentVariable("NO_COLOR"), Environment.GetEnvironmentVariable("TERM"), OperatingSystem.IsWindows());
        if (refusal is not null)
        {
            return new PreviewScreen(null, refusal);
        }

        IAnsiConsole terminal = AnsiConsole.Create(new AnsiConsoleSettings { Out = new AnsiConsoleOutput(Console.Out) });
        bool hasColors = terminal.Profile.Capabilities.Ansi && terminal.Profile.Capabilities.ColorSystem is not (ColorSystem.NoColors or ColorSystem.Legacy);
        return hasColors ? On(terminal) : new PreviewScreen(null, "this terminal shows too few colours");
    }

    /// <summary>Why colours must not be written, by what the process is told; null if they may.</summary>
    /// <param name="isRedirected">Whether the output goes into a pipe or a file.</param>
    /// <param name="noColor">The variable NO_COLOR; not empty means no colours (https://no-color.org).</param>
    /// <param name="term">The variable TERM.</param>
    /// <param name="isWindows">On Windows TERM is not set as a rule.</param>
    public static string? FindRefusal(bool isRedirected, string? noColor, string? term, bool isWindows)
    {
        if (isRedirected)
        {
            return NoTerminal;
        }

        if (!string.IsNullOrEmpty(noColor))
        {
            return "NO_COLOR is set";
        }

        return term == "dumb" ? "TERM=dumb: the terminal shows no colours"
            : string.IsNullOrEmpty(term) && !isWindows ? "TERM is not set, so nobody knows what the terminal can show"
            : null;
    }
}
