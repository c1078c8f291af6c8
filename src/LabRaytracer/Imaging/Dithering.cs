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
}
