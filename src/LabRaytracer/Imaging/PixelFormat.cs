namespace LabRaytracer;

/// <summary>How the samples of a <see cref="PixelBuffer"/> are stored; always four channels: red, green, blue, alpha.</summary>
public enum PixelFormat
{
    /// <summary>One byte a channel, 0..255.</summary>
    Rgba8,

    /// <summary>One 16-bit word a channel, 0..65535.</summary>
    Rgba16,

    /// <summary>One float a channel; colour is unbounded, alpha is in [0, 1].</summary>
    RgbaFloat,
}
