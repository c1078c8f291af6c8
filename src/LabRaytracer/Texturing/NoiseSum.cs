namespace LabRaytracer;

/// <summary>What the octaves of a noise add up to.</summary>
public enum NoiseSum
{
    /// <summary>Fractional Brownian motion: the octaves as they are, around 0.</summary>
    Fbm,

    /// <summary>Turbulence: the absolute values of the octaves, 0 and above, with creases where an octave changes its sign.</summary>
    Turbulence,
}
