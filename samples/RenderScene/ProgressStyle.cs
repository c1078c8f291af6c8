namespace RenderScene;

/// <summary>How progress is shown.</summary>
internal enum ProgressStyle
{
    /// <summary>Not at all.</summary>
    None,

    /// <summary>A line for every 10 percent: for pipes and log files.</summary>
    Lines,

    /// <summary>A bar that moves, with the time left: for terminals.</summary>
    Bar,
}
