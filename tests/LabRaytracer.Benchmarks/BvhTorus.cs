namespace LabRaytracer.Benchmarks;

/// <summary>The displaced torus of the bench scene s4: 1000 x 500 quads, a million triangles.</summary>
internal static class BvhTorus
{
    private const int Across = 1000, Around = 500;

    public static TriangleMesh Mesh()
    {
        int vertices = (Across + 1) * (Around + 1);
        double[] positions = new double[3 * vertices], normals = new double[3 * vertices], coordinates = new double[2 * vertices];
        List<int> corners = new(6 * Across * Around);
        for (int vertex = 0; vertex < vertices; vertex++)
        {
            int i = vertex / (Around + 1), k = vertex % (Around + 1);
            Put(positions.AsSpan(3 * vertex), normals.AsSpan(3 * vertex), coordinates.AsSpan(2 * vertex), i / (double)Across, k / (double)Around);
            if (i < Across && k < Around)
            {
                int beyond = vertex + Around + 1;
                corners.AddRange([vertex, beyond, vertex + 1, vertex + 1, beyond, beyond + 1]);
            }
        }

        return new TriangleMesh(positions, corners.ToArray(), new MeshOptions { Normals = normals, TextureCoordinates = coordinates });
    }

    private static void Put(Span<double> position, Span<double> normal, Span<double> coordinate, double u, double v)
    {
        (double sinU, double cosU) = Math.SinCos(2 * Math.PI * u);
        (double sinV, double cosV) = Math.SinCos(2 * Math.PI * v);
        double tube = 0.4 * (1 + (0.06 * Math.Sin(2 * Math.PI * 40 * u) * Math.Sin(2 * Math.PI * 20 * v)));
        double ring = 1 + (tube * cosV);
        (position[0], position[1], position[2]) = (ring * sinU, tube * sinV, ring * cosU);
        (normal[0], normal[1], normal[2]) = (cosV * sinU, sinV, cosV * cosU);
        (coordinate[0], coordinate[1]) = (u, v);
    }
}
