namespace LabRaytracer;

/// <summary>Transform of texture coordinates.</summary>
public sealed class UvTransform
{
    /// <summary>No change.</summary>
    public static UvTransform Identity { get; } = new();
}
