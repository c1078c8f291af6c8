namespace LabRaytracer;

/// <summary>How scene files are loaded.</summary>
/// <remarks>Immutable, thread safe. Setters throw <see cref="ArgumentOutOfRangeException"/> outside the stated ranges.</remarks>
public sealed class SceneLoadOptions
{
    private readonly long _maxBytes = 256L << 20;
    private readonly long _maxMeshBytes = 1L << 30;

    /// <summary>Everything as stated at the properties.</summary>
    public static SceneLoadOptions Default { get; } = new();

    /// <summary>
    /// Tells whether a scene may name files outside its own folder: absolute paths and paths with "..". Default: no, so that a scene
    /// from somewhere else cannot read what it should not.
    /// </summary>
    public bool AllowOutsidePaths { get; init; }

    /// <summary>
    /// Told the absolute path of every file that the scene, or a file of it, names, before the file is read and even if it does not exist: so that a program can
    /// wait for changes of a scene with mistakes too. Called by the loading thread; null (default) for nobody.
    /// </summary>
    public Action<string>? FileNamed { get; init; }

    /// <summary>What becomes of a scene whose pictures are missing or damaged. Default: it is refused.</summary>
    /// <exception cref="ArgumentOutOfRangeException">Not one of the enumeration.</exception>
    public MissingPictures MissingPictures { get; init => field = PropertyChecks.Known(value); }

    /// <summary>
    /// Told of every picture that a checker stands in for, and of the place that names it: while the scene is read if the file is missing, when it is first needed if it is
    /// damaged; once a file, by any thread. Null (default) for nobody.
    /// </summary>
    public Action<SceneFileError>? Warned { get; init; }

    /// <summary>Largest scene file, bytes, [1, 2147483591]. Default: 256 MiB.</summary>
    public long MaxBytes
    {
        get => _maxBytes;
        init => _maxBytes = InRange(value);
    }

    /// <summary>Largest OBJ or MTL file, bytes, [1, 2147483591]. Default: 1 GiB.</summary>
    public long MaxMeshBytes
    {
        get => _maxMeshBytes;
        init => _maxMeshBytes = InRange(value);
    }

    private static long InRange(long value) => value >= 1 && value <= Array.MaxLength
        ? value
        : throw new ArgumentOutOfRangeException(nameof(value), value, $"Allowed: 1 to {Array.MaxLength} bytes.");
}
