namespace LabRaytracer.Validation;

/// <summary>Shapes and the rays that are hard for them.</summary>
internal static class StressRays
{
    /// <summary>Names of the classes of rays.</summary>
    public static readonly string[] Kinds = ["generic", "far", "grazing", "grazing far", "tiny", "huge", "inside", "on the surface", "behind", "not unit", "along an axis"];

    /// <summary>A shape of a class, with a size and a place that suit a class of rays.</summary>
    public static Shape Create(Draws draws, string name, string kind, out Point3D center, out double size)
    {
        size = kind switch { "tiny" => draws.Scale(-30, -6), "huge" => draws.Scale(6, 30), _ => draws.Scale(-1, 1) };
        Point3D c = center = draws.Integer(3) == 0 ? Point3D.Origin : Point3D.Origin + (draws.Direction() * (size * draws.Scale(-1, 2)));
        double s = size;
        Vector3D Edge() => draws.Direction() * (s * draws.Number(0.5, 2));
        Vector3D first = Edge(), second = draws.Across(first.Normalized()) * (s * draws.Number(0.5, 2)) + (first * draws.Number(-0.3, 0.3));
        return name switch
        {
            "sphere" => new Sphere(c, s),
            "cylinder" => new Cylinder(c, s, s * draws.Number(0.5, 4)),
            "plane" => new InfinitePlane(c, draws.Integer(3) == 0 ? Vector3D.UnitY : draws.Direction()),
            "disk" => new Disk(c, draws.Integer(3) == 0 ? Vector3D.UnitY : draws.Direction(), s),
            "quad" => new Quad(c - (first * 0.5) - (second * 0.5), first, second),
            "box" => new Box(c - new Vector3D(s, s * 0.5, s * 0.75), c + new Vector3D(s, s, s * 0.25)),
            "triangle" => new Triangle(c + first, c + second, c - (first * 0.5)),
            _ => throw new ArgumentException($"There is no shape '{name}'.", nameof(name)),
        };
    }

    /// <summary>A ray of a class that looks for a shape around a centre.</summary>
    public static Ray At(Draws draws, string kind, Point3D center, double size)
    {
        Vector3D out1 = draws.Direction();
        Point3D Around(double reach) => center + (draws.Direction() * (size * reach));
        Ray To(Point3D from, Point3D target) => new(from, Unit(target - from, draws));
        return kind switch
        {
            "far" => To(Around(draws.Scale(3, 12)), Around(draws.Number(0, 1.1))),
            "grazing" => Grazing(draws, center, size, draws.Scale(0, 2)),
            "grazing far" => Grazing(draws, center, size, draws.Scale(3, 12)),
            "inside" => new Ray(Around(draws.Number(0, 0.99)), draws.Direction()),
            "on the surface" => new Ray(center + (out1 * size), draws.Direction()),
            "behind" => new Ray(center + (out1 * (size * draws.Scale(0.1, 3))), (out1 + (draws.Direction() * 0.9)).Normalized()),
            "not unit" => Stretched(draws, To(Around(draws.Scale(0.1, 2)), Around(draws.Number(0, 1.1)))),
            "along an axis" => AlongAxis(draws, center, size),
            _ => To(Around(draws.Scale(0.1, 1.5)), Around(draws.Number(0, 1.1))),
        };
    }

    private static Vector3D Unit(Vector3D direction, Draws draws) => direction == Vector3D.Zero ? draws.Direction() : direction.Normalized();

    /// <summary>Past the sphere of the size, nearer and nearer to touching it, from inside or from outside.</summary>
    private static Ray Grazing(Draws draws, Point3D center, double size, double distance)
    {
        Vector3D outward = draws.Direction(), along = draws.Across(outward);
        Point3D touch = center + (outward * (size * (1 + (draws.Sign() * draws.Scale(-16.5, -1)))));
        Point3D from = touch - (along * (size * distance));
        return new Ray(from, Unit(touch - from, draws));
    }

    private static Ray Stretched(Draws draws, in Ray ray) => new(ray.Origin, ray.Direction * draws.Scale(-6, 6));

    /// <summary>Parallel to an axis, or almost.</summary>
    private static Ray AlongAxis(Draws draws, Point3D center, double size)
    {
        Vector3D axis = (Vector3D)(draws.Integer(3) switch { 0 => Vector3D.UnitX, 1 => Vector3D.UnitY, _ => Vector3D.UnitZ }) * draws.Sign();
        Vector3D tilt = draws.Integer(3) == 0 ? Vector3D.Zero : draws.Across(axis) * draws.Scale(-16, -2);
        Vector3D aside = draws.Across(axis) * (size * draws.Number(0, 1.1));
        return new Ray(center + aside - (axis * (size * draws.Scale(0.1, 2))), (axis + tilt).Normalized());
    }
}
