namespace LabRaytracer;

/// <summary>Time against size of a PNG file; the picture is the same.</summary>
public enum PngCompression
{
    /// <summary>Least time.</summary>
    Fastest,

    /// <summary>Little time, a small file.</summary>
    Default,

    /// <summary>Smallest file, whatever it takes.</summary>
    Smallest,
}
