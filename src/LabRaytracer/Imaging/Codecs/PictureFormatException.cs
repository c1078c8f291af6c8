namespace LabRaytracer;

/// <summary>A picture file cannot be used: damaged, not supported, or over a limit. The message is one line.</summary>
public sealed class PictureFormatException : Exception
{
    /// <summary>Makes the exception.</summary>
    /// <param name="path">The file, as the caller named it.</param>
    /// <param name="reason">What is wrong, without the file's name.</param>
    /// <param name="innerException">What was thrown underneath, if anything.</param>
    public PictureFormatException(string path, string reason, Exception? innerException = null)
        : base($"Cannot read picture '{OneLine(path)}': {OneLine(reason)}.", innerException)
    {
        Path = path;
        Reason = OneLine(reason);
    }

    /// <summary>The file, as the caller named it.</summary>
    public string Path { get; }

    /// <summary>What is wrong, without the file's name.</summary>
    public string Reason { get; }

    /// <summary>Text out of a damaged file may hold anything: control characters would break the line or the terminal.</summary>
    private static string OneLine(string text) => string.Concat((text ?? string.Empty).Select(c => char.IsControl(c) ? '?' : c));
}
