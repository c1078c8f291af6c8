namespace LabRaytracer.Validation;

/// <summary>A closed mesh around the origin: an octahedron, divided four ways each time, with every vertex moved in or out.</summary>
internal sealed class BumpyBall
{
    private readonly List<Point3D> _vertices;
    private readonly int[] _corners;

    public BumpyBall(Draws draws, int divisions)
    {
        List<Vector3D> points = [Vector3D.UnitX, Vector3D.UnitY, Vector3D.UnitZ, -Vector3D.UnitX, -Vector3D.UnitY, -Vector3D.UnitZ];
        List<int> faces = [0, 1, 2, 1, 3, 2, 3, 4, 2, 4, 0, 2, 1, 0, 5, 3, 1, 5, 4, 3, 5, 0, 4, 5];
        for (int i = 0; i < divisions; i++)
        {
            faces = Divide(faces, points);
        }

        _vertices = [.. points.Select(p => Point3D.Origin + (p.Normalized() * draws.Number(0.8, 1.2)))];
        _corners = [.. faces];
        Mesh = new TriangleMesh(_vertices, _corners);
    }

    /// <summary>The mesh.</summary>
    public TriangleMesh Mesh { get; }

    /// <summary>Rays from places near the middle to all vertices and to points of all edges.</summary>
    public Ray[] AimedRays(Draws draws)
    {
        Ray Aim(Point3D target)
        {
            Point3D from = Point3D.Origin + (draws.Direction() * draws.Number(0, 0.3));
            return new Ray(from, target - from);
        }

        IEnumerable<Ray> edges = Enumerable.Range(0, _corners.Length).Select(i =>
        {
            Point3D start = _vertices[_corners[i]];
            return Aim(start + ((_vertices[_corners[i % 3 == 2 ? i - 2 : i + 1]] - start) * draws.Number()));
        });
        return [.. _vertices.Select(Aim), .. edges];
    }

    private static List<int> Divide(List<int> faces, List<Vector3D> points)
    {
        Dictionary<(int, int), int> middles = [];
        int Middle(int a, int b)
        {
            (int, int) key = (Math.Min(a, b), Math.Max(a, b));
            if (!middles.TryGetValue(key, out int middle))
            {
                middle = middles[key] = points.Count;
                points.Add((points[a] + points[b]) * 0.5);
            }

            return middle;
        }

        List<int> result = [];
        for (int i = 0; i < faces.Count; i += 3)
        {
            (int a, int b, int c) = (faces[i], faces[i + 1], faces[i + 2]);
            (int ab, int bc, int ca) = (Middle(a, b), Middle(b, c), Middle(c, a));
            result.AddRange([a, ab, ca, ab, b, bc, ca, bc, c, ab, bc, ca]);
        }

        return result;
    }
}
