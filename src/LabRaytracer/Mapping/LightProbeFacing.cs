namespace LabRaytracer;

/// <summary>The direction in the middle of a light probe.</summary>
public enum LightProbeFacing
{
    /// <summary>+Z in the middle, -Z all around the rim: the light probes of P. Debevec.</summary>
    PositiveZ,

    /// <summary>-Z in the middle, +Z all around the rim: what a camera that looks along -Z sees around it.</summary>
    NegativeZ,
}
