namespace LabRaytracer;

/// <summary>A reflected or refracted ray that waits for its turn: as long as a cache line.</summary>
/// <remarks>Numbers, not vectors: it is written number by number where it lies, and a vector that has just been written so is slow to copy.</remarks>
internal struct SecondaryRay
{
    /// <summary>Origin, world space.</summary>
    public double OriginX, OriginY, OriginZ;

    /// <summary>Direction, world space, length 1.</summary>
    public double DirectionX, DirectionY, DirectionZ;

    /// <summary>Share of its light that reaches the pixel.</summary>
    public float Red, Green, Blue;

    /// <summary>Number of the pixel in the tile.</summary>
    public int Pixel;

    /// <summary>Share of its light that reaches the pixel.</summary>
    public readonly Intensity Weight => new(Red, Green, Blue);
}
