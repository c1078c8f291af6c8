namespace LabRaytracer;

/// <summary>A half-line: the points <c>Origin + t * Direction</c> for t above 0.</summary>
/// <param name="Origin">Start point, scene units.</param>
/// <param name="Direction">Direction; any finite length above 0. Distances t are in units of this length.</param>
/// <remarks>Immutable, thread safe.</remarks>
public readonly record struct Ray(Point3D Origin, Vector3D Direction)
{
    /// <summary>The point <c>Origin + t * Direction</c>, each coordinate correctly rounded.</summary>
    /// <param name="t">Ray parameter, in lengths of <see cref="Direction"/>.</param>
    public Point3D PointAt(double t) => new(
        Math.FusedMultiplyAdd(t, Direction.X, Origin.X),
        Math.FusedMultiplyAdd(t, Direction.Y, Origin.Y),
        Math.FusedMultiplyAdd(t, Direction.Z, Origin.Z));
}
