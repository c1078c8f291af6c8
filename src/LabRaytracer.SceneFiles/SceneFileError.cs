namespace LabRaytracer;

/// <summary>One mistake in a scene file or in a file that it names.</summary>
/// <param name="File">The file, as it was named when it was opened.</param>
/// <param name="Line">Line, from 1.</param>
/// <param name="Column">Column in UTF-16 characters, from 1.</param>
/// <param name="Message">What is wrong, on one line.</param>
/// <param name="Allowed">What would be right, on one line; null where the message says it all.</param>
/// <remarks>Immutable, thread safe.</remarks>
public sealed record SceneFileError(string File, int Line, int Column, string Message, string? Allowed)
{
    /// <summary>Creates the description of a mistake at a place.</summary>
    /// <param name="location">Where.</param>
    /// <param name="message">What is wrong, on one line.</param>
    /// <param name="allowed">What would be right; null where the message says it all.</param>
    public SceneFileError(SceneLocation location, string message, string? allowed = null)
        : this(location.File, location.Line, location.Column, message, allowed)
    {
    }

    /// <summary>Where the mistake is.</summary>
    public SceneLocation Location => new(File, Line, Column);

    /// <summary>One line: file:line:column: what; allowed: ...</summary>
    public override string ToString() => Allowed is null ? $"{Location}: {Message}" : $"{Location}: {Message}; allowed: {Allowed}";
}
