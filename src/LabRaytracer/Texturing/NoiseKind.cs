namespace LabRaytracer;

/// <summary>How a noise gets from lattice points to the space between them.</summary>
public enum NoiseKind
{
    /// <summary>Improved Perlin noise: random gradients, quintic blend; 0 at lattice points, twice continuously differentiable, within ±1.0364.</summary>
    Gradient,

    /// <summary>Random values at lattice points, linear in between: continuous, with creases, in [-1, 1).</summary>
    Value,

    /// <summary>Random values at lattice points, Catmull-Rom cubics in between: a continuous slope, clamped to [-1, 1].</summary>
    Cubic,

    /// <summary>
    /// Simplex noise: random gradients at the corners of tetrahedra, four instead of eight; no grain along the axes, three times continuously differentiable, 0 at
    /// corners, in [-1, 1].
    /// </summary>
    Simplex,
}
