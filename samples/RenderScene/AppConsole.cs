namespace RenderScene;

/// <summary>Where results, messages and progress go.</summary>
/// <param name="Output">Results: what a pipe should carry on.</param>
/// <param name="Error">Messages and progress.</param>
/// <param name="Progress">How progress is shown.</param>
internal sealed record AppConsole(TextWriter Output, TextWriter Error, ProgressStyle Progress)
{
    /// <summary>Finds the terminal for previews; only asked for when one is wanted. Default: there is none.</summary>
    public Func<PreviewScreen> Screen { get; init; } = () => PreviewScreen.None;

    /// <summary>The console of the process: a bar on a terminal, lines in a pipe.</summary>
    public static AppConsole System()
    {
        bool isPlain = Console.IsErrorRedirected || Environment.GetEnvironmentVariable("TERM") is null or "" or "dumb";
        ProgressStyle progress = isPlain && !OperatingSystem.IsWindows() || Console.IsErrorRedirected ? ProgressStyle.Lines : ProgressStyle.Bar;
        return new AppConsole(Console.Out, Console.Error, progress) { Screen = PreviewScreen.System };
    }
}
