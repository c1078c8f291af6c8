namespace LabRaytracer.Tests.Geometry;

/// <summary>Shapes at random places and of random sizes, and rays that look for them.</summary>
internal sealed class ShapeCases(int seed)
{
    public static readonly string[] Kinds = ["sphere", "plane", "quad", "disk", "cylinder", "box", "triangle", "torus", "cone"];

    private readonly Random _random = new(seed);

    /// <summary>A shape of a size around a centre; its true (inner) extent is about the size.</summary>
    public Shape Create(string kind, Point3D center, double size) => kind switch
    {
        "sphere" => new Sphere(center, size),
        "plane" => new InfinitePlane(center, UnitVector()),
        "quad" => new Quad(center + (size * UnitVector()), size * UnitVector() * 1.5, size * UnitVector()),
        "disk" => new Disk(center, UnitVector(), size),
        "cylinder" => new Cylinder(center, size, size * (0.5 + _random.NextDouble())),
        "box" => new Box(center + new Vector3D(-size, -size * 0.5, -size * 0.75), center + new Vector3D(size, size, size * 0.25)),
        "triangle" => new Triangle(center + (size * UnitVector()), center + (size * UnitVector()), center + (size * UnitVector())),
        "torus" => new Torus(center, size, size * Number(0.02, 0.95)),
        "cone" => new Cone(center, size, size * Number(0.3, 3), _random.Next(2) == 0 ? ConeCaps.Open : ConeCaps.Closed),
        _ => throw new ArgumentException($"Unknown kind '{kind}'.", nameof(kind)),
    };

    public double Number(double from, double to) => from + ((to - from) * _random.NextDouble());

    /// <summary>10 to a uniformly distributed power.</summary>
    public double Scale(double fromPower, double toPower) => Math.Pow(10, Number(fromPower, toPower));

    public Vector3D UnitVector()
    {
        while (true)
        {
            Vector3D v = new(Number(-1, 1), Number(-1, 1), Number(-1, 1));
            if (v.Length is > 0.01 and < 1)
            {
                return v.Normalized();
            }
        }
    }

    public Point3D Center(double reach) => new(Number(-reach, reach), Number(-reach, reach), Number(-reach, reach));

    /// <summary>Rotation, uneven scale, mirror and translation.</summary>
    public Transform Transform(double reach) => LabRaytracer.Transform
        .Rotation(UnitVector(), Number(0, 360))
        .Then(LabRaytracer.Transform.Scaling(new Vector3D(Scale(-1, 1), Scale(-1, 1), (_random.Next(2) == 0 ? 1 : -1) * Scale(-1, 1))))
        .Then(LabRaytracer.Transform.Rotation(UnitVector(), Number(0, 360)))
        .Then(LabRaytracer.Transform.Translation(UnitVector() * reach));

    /// <summary>A ray from somewhere outside (or inside) to somewhere near the shape, unit direction, world space.</summary>
    public Ray RayAt(Point3D center, double size, Transform transform)
    {
        Point3D from = transform.WorldFromObject(center + (UnitVector() * (size * Scale(-1, 2))));
        Point3D to = transform.WorldFromObject(center + (UnitVector() * (size * Number(0, 1.2))));
        Vector3D direction = to - from;
        return new Ray(from, direction == Vector3D.Zero ? UnitVector() : direction.Normalized());
    }
}
