namespace RenderScene;

/// <summary>What the program tells the shell.</summary>
internal static class ExitCode
{
    /// <summary>Everything was done.</summary>
    public const int Done = 0;

    /// <summary>The check that was asked for failed.</summary>
    public const int CheckFailed = 1;

    /// <summary>The command line cannot be used.</summary>
    public const int Usage = 2;

    /// <summary>A file cannot be read, written or understood.</summary>
    public const int BadInput = 3;

    /// <summary>Stopped by Ctrl-C (128 + signal 2, as shells count).</summary>
    public const int Cancelled = 130;

    /// <summary>Stopped by SIGTERM (128 + signal 15).</summary>
    public const int Terminated = 143;
}
