namespace LabRaytracer;

/// <summary>How a scene file wants its picture written.</summary>
/// <remarks>Immutable, thread safe.</remarks>
public sealed class SceneOutput
{
    /// <summary>No file name; 8 bits, sRGB, clamped.</summary>
    public static SceneOutput Default { get; } = new();

    /// <summary>Name of the picture file, without folders; null (default) where the scene does not name one.</summary>
    public string? FileName { get; init; }

    /// <summary>Encoding, bit depth and tone mapping.</summary>
    public PictureSaveOptions Picture { get; init => field = PropertyChecks.NotNull(value); } = PictureSaveOptions.Default;
}
