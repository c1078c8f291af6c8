namespace LabRaytracer;

/// <summary>Whether smooth light is broken up when it is rounded to codes of 8 bits.</summary>
public enum Dithering
{
    /// <summary>Every light gets the code whose interval holds it; very smooth gradients show bands.</summary>
    None,

    /// <summary>
    /// Ordered dither, 8 x 8 pixels: of two neighbouring codes the brighter one is as frequent as light lies near to it, so that the mean light of every 8 x 8 pixels
    /// stays the same within 1/128 of the step between the two codes. Light that is exactly that of a code keeps it (Bayer 1973).
    /// </summary>
    Ordered,

    /// <summary>
    /// Blue noise, 64 x 64 pixels: as <see cref="Ordered"/>, but with thresholds that have no pattern, only a fine grain. The mean light of every 64 x 64 pixels stays the
    /// same within 1/8192 of the step between the two codes (Ulichney 1993).
    /// </summary>
    BlueNoise,
}
