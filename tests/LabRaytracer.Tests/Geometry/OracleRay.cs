using System.Globalization;

namespace LabRaytracer.Tests.Geometry;

/// <summary>One row of Data/rays.csv: a ray, a shape, and the truth to 60 digits (Oracle/geometry_rays.py).</summary>
internal sealed record OracleRay(string Kind, string ShapeName, double Gap, double? T, double[] Local, Ray Ray, Shape Shape)
{
    public static IEnumerable<OracleRay> Read()
    {
        string folder = AppContext.BaseDirectory;
        while (!File.Exists(Path.Combine(folder, "LabRaytracer.sln")))
        {
            folder = Path.GetDirectoryName(folder) ?? throw new DirectoryNotFoundException("The tests must run inside the repository.");
        }

        return File.ReadLines(Path.Combine(folder, "tests", "LabRaytracer.Tests", "Geometry", "Data", "rays.csv")).Select(Parse);
    }

    private static OracleRay Parse(string line)
    {
        string[] words = line.Split(',');
        double[] n = [.. words[4..].Select(word => double.Parse(word, CultureInfo.InvariantCulture))];
        double[] numbers = n[9..];
        Ray ray = new(Point(n, 3), Point(n, 6).ToVector());
        return new OracleRay(
            words[0],
            words[1],
            double.Parse(words[2], CultureInfo.InvariantCulture),
            words[3] == "miss" ? null : double.Parse(words[3], CultureInfo.InvariantCulture),
            n[..3],
            ray,
            Create(words[1], numbers));
    }

    private static Shape Create(string name, double[] n) => name switch
    {
        "sphere" => new Sphere(Point(n, 0), n[3]),
        "cylinder" => new Cylinder(Point(n, 0), n[3], n[4]),
        "plane" => new InfinitePlane(Point(n, 0), Point(n, 3).ToVector()),
        "quad" => new Quad(Point(n, 0), Point(n, 3).ToVector(), Point(n, 6).ToVector()),
        "disk" => new Disk(Point(n, 0), Vector3D.UnitY, n[3]),
        "box" => new Box(Point(n, 0), Point(n, 3)),
        "triangle" => new Triangle(Point(n, 0), Point(n, 3), Point(n, 6)),
        _ => throw new ArgumentException($"Unknown shape '{name}'.", nameof(name)),
    };

    private static Point3D Point(double[] n, int at) => new(n[at], n[at + 1], n[at + 2]);
}
