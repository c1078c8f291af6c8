namespace LabRaytracer.Tests;

/// <summary>Meshes and rays with fixed seeds.</summary>
internal static class MeshSamples
{
    /// <summary>A soup of small triangles around a place.</summary>
    public static TriangleMesh Soup(int triangles, double size, Vector3D offset, int seed)
    {
        Random random = new(seed);
        List<Point3D> points = [];
        for (int i = 0; i < triangles; i++)
        {
            Vector3D middle = Inside(random) + offset;
            for (int k = 0; k < 3; k++)
            {
                points.Add(Point3D.Origin + middle + (Inside(random) * size));
            }
        }

        return new TriangleMesh(points, Numbers(3 * triangles));
    }

    /// <summary>The numbers 0, 1, 2, ...</summary>
    public static int[] Numbers(int count) => [.. Enumerable.Range(0, count)];

    /// <summary>A closed surface around the origin: an icosahedron, divided four ways each time, with every vertex moved in or out.</summary>
    public static TriangleMesh BumpyBall(int divisions, int seed, out Point3D[] vertices, out int[] corners)
    {
        List<Point3D> points = [];
        double golden = (1 + Math.Sqrt(5)) / 2;
        double[,] start =
        {
            { -1, golden, 0 }, { 1, golden, 0 }, { -1, -golden, 0 }, { 1, -golden, 0 }, { 0, -1, golden }, { 0, 1, golden },
            { 0, -1, -golden }, { 0, 1, -golden }, { golden, 0, -1 }, { golden, 0, 1 }, { -golden, 0, -1 }, { -golden, 0, 1 },
        };
        for (int i = 0; i < 12; i++)
        {
            points.Add(new Point3D(start[i, 0], start[i, 1], start[i, 2]));
        }

        List<int> faces =
        [
            0, 11, 5, 0, 5, 1, 0, 1, 7, 0, 7, 10, 0, 10, 11, 1, 5, 9, 5, 11, 4, 11, 10, 2, 10, 7, 6, 7, 1, 8,
            3, 9, 4, 3, 4, 2, 3, 2, 6, 3, 6, 8, 3, 8, 9, 4, 9, 5, 2, 4, 11, 6, 2, 10, 8, 6, 7, 9, 8, 1,
        ];
        for (int division = 0; division < divisions; division++)
        {
            faces = Divide(faces, points);
        }

        Random random = new(seed);
        vertices = [.. points.Select(p => Point3D.Origin + (p.ToVector().Normalized() * (0.8 + (0.4 * random.NextDouble()))))];
        corners = [.. faces];
        return new TriangleMesh(vertices, corners);
    }

    /// <summary>Rays from many places in many directions; a third of them along axes or in coordinate planes.</summary>
    public static Ray[] Rays(int count, Vector3D offset, double distance, int seed)
    {
        Random random = new(seed);
        Ray[] rays = new Ray[count];
        for (int i = 0; i < count; i++)
        {
            Point3D origin = Point3D.Origin + offset + (Inside(random) * distance);
            Point3D target = Point3D.Origin + offset + Inside(random);
            Vector3D direction = target - origin;
            if (i % 3 == 0)
            {
                int zeros = 1 + random.Next(6);
                direction = new Vector3D((zeros & 1) == 0 ? direction.X : 0, (zeros & 2) == 0 ? direction.Y : -0.0, (zeros & 4) == 0 ? direction.Z : 0);
            }

            rays[i] = new Ray(origin, direction * Math.Pow(10, random.Next(-2, 3)));
        }

        return rays;
    }

    /// <summary>A vector with coordinates in [-1, 1).</summary>
    public static Vector3D Inside(Random random) => new((2 * random.NextDouble()) - 1, (2 * random.NextDouble()) - 1, (2 * random.NextDouble()) - 1);

    private static List<int> Divide(List<int> faces, List<Point3D> points)
    {
        Dictionary<(int, int), int> middles = [];
        int Middle(int a, int b)
        {
            (int, int) key = (Math.Min(a, b), Math.Max(a, b));
            if (!middles.TryGetValue(key, out int middle))
            {
                middle = points.Count;
                points.Add(Point3D.Origin + ((points[a].ToVector() + points[b].ToVector()).Normalized() * 1.0));
                middles.Add(key, middle);
            }

            return middle;
        }

        List<int> divided = [];
        for (int i = 0; i < faces.Count; i += 3)
        {
            int a = faces[i], b = faces[i + 1], c = faces[i + 2];
            int ab = Middle(a, b), bc = Middle(b, c), ca = Middle(c, a);
            divided.AddRange([a, ab, ca, b, bc, ab, c, ca, bc, ab, bc, ca]);
        }

        return divided;
    }
}
