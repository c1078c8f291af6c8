namespace LabRaytracer;

/// <summary>A scene file, or a file that it names, cannot be used. The message has one line for each mistake.</summary>
public sealed class SceneFileException : Exception
{
    /// <summary>Creates the exception.</summary>
    /// <param name="errors">The mistakes in the order of the file; at least one.</param>
    /// <param name="inner">The failure behind it; null for none.</param>
    /// <exception cref="ArgumentException">There is no mistake.</exception>
    public SceneFileException(IReadOnlyList<SceneFileError> errors, Exception? inner = null)
        : base(string.Join('\n', errors ?? throw new ArgumentNullException(nameof(errors))), inner)
    {
        if (errors.Count == 0)
        {
            throw new ArgumentException("The exception needs at least one mistake.", nameof(errors));
        }

        Errors = [.. errors];
    }

    /// <summary>Creates the exception for one mistake.</summary>
    /// <param name="error">The mistake.</param>
    /// <param name="inner">The failure behind it; null for none.</param>
    public SceneFileException(SceneFileError error, Exception? inner = null)
        : this([error ?? throw new ArgumentNullException(nameof(error))], inner)
    {
    }

    /// <summary>The mistakes in the order of the file; at least one.</summary>
    public IReadOnlyList<SceneFileError> Errors { get; }
}
