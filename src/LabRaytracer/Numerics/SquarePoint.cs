namespace LabRaytracer;

/// <summary>A point of the unit square: where a sample lies on a lamp or a lens.</summary>
/// <param name="S">First coordinate, [0, 1).</param>
/// <param name="T">Second coordinate, [0, 1).</param>
/// <remarks>Immutable, thread safe.</remarks>
public readonly record struct SquarePoint(double S, double T)
{
    /// <summary>The middle of the square, (1/2, 1/2).</summary>
    public static SquarePoint Center => new(0.5, 0.5);
}
