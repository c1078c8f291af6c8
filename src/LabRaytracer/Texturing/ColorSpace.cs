namespace LabRaytracer;

/// <summary>How the numbers of a picture file become linear colour.</summary>
public enum ColorSpace
{
    /// <summary>In colour slots what the file says (8-bit files: sRGB); in data slots (shininess, ...) the numbers as they are.</summary>
    Auto,

    /// <summary>Decoded as sRGB everywhere.</summary>
    Srgb,

    /// <summary>The numbers as they are, 0 to 1, everywhere.</summary>
    Linear,
}
