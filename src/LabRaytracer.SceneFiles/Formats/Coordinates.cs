namespace LabRaytracer;

/// <summary>Points, vectors and texture coordinates of scene files.</summary>
internal static class Coordinates
{
    public static NumbersFormat<Point3D> Point { get; } = new(
        3, "three numbers [x, y, z]", n => new Point3D(n[0], n[1], n[2]), p => [p.X, p.Y, p.Z]);

    public static NumbersFormat<Vector3D> Vector { get; } = new(
        3, "three numbers [x, y, z]", n => new Vector3D(n[0], n[1], n[2]), v => [v.X, v.Y, v.Z]);

    /// <summary>A vector with a direction.</summary>
    public static NumbersFormat<Vector3D> Direction { get; } = new(
        3, "three numbers [x, y, z], not all 0", n => n.All(number => number == 0) ? null : new Vector3D(n[0], n[1], n[2]), v => [v.X, v.Y, v.Z]);

    public static NumbersFormat<TextureCoordinate> Uv { get; } = new(
        2, "two numbers [u, v]", n => new TextureCoordinate(n[0], n[1]), c => [c.U, c.V]);
}
