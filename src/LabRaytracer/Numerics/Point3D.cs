namespace LabRaytracer;

/// <summary>A position in right-handed, y-up space, in double precision.</summary>
/// <param name="X">Coordinate along +X, scene units.</param>
/// <param name="Y">Coordinate along +Y (up), scene units.</param>
/// <param name="Z">Coordinate along +Z, scene units.</param>
/// <remarks>Immutable, thread safe. The default value is the origin.</remarks>
public readonly record struct Point3D(double X, double Y, double Z)
{
    /// <summary>The point (0, 0, 0).</summary>
    public static Point3D Origin => default;

    /// <summary>Tells whether no coordinate is NaN or infinite.</summary>
    public bool IsFinite => double.IsFinite(X) && double.IsFinite(Y) && double.IsFinite(Z);

    /// <summary>The point displaced by a vector.</summary>
    public static Point3D operator +(Point3D point, Vector3D displacement) =>
        new(point.X + displacement.X, point.Y + displacement.Y, point.Z + displacement.Z);

    /// <summary>The point displaced by the opposite of a vector.</summary>
    public static Point3D operator -(Point3D point, Vector3D displacement) =>
        new(point.X - displacement.X, point.Y - displacement.Y, point.Z - displacement.Z);

    /// <summary>The vector that leads from <paramref name="from"/> to <paramref name="to"/>.</summary>
    public static Vector3D operator -(Point3D to, Point3D from) => new(to.X - from.X, to.Y - from.Y, to.Z - from.Z);

    /// <summary>The vector from the origin to this point.</summary>
    public Vector3D ToVector() => new(X, Y, Z);
}
