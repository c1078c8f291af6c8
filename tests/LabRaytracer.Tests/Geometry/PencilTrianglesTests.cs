namespace LabRaytracer.Tests;

/// <summary>What is prepared in floats (<see cref="PencilTriangles"/>) against the same in doubles, whose errors are far below the bounds.</summary>
public unsafe class PencilTrianglesTests
{
    private const double Slack = 1 + 1e-6;

    [Theory]
    [InlineData(1, 0.01, 0.01)]
    [InlineData(1, 1e-5, 0.01)]
    [InlineData(1, 1.5, 0.5)]
    [InlineData(1e-4, 1e-6, 1e-3)]
    [InlineData(1e6, 1e3, 1)]
    public void Prepare_RandomTriangles_WithinBounds(double scale, double size, double spread)
    {
        Random random = new(23);
        int known = 0;
        for (int round = 0; round < 300; round++)
        {
            RayPencil pencil = Pencil(random, scale, spread);
            double[] numbers = [.. Enumerable.Range(0, PencilTriangles.Most).SelectMany(_ => Triangle(random, pencil, scale, size)), 0];
            known += Check<Float4>(pencil, numbers, isSingle: false) + Check<Float16>(pencil, numbers, isSingle: true);
        }

        Assert.True(known > 1000, $"{known}");
    }

    [Fact]
    public void Of_AllBits_ListsThem()
    {
        for (uint bits = 0; bits < 256; bits++)
        {
            int[] expected = [.. Enumerable.Range(0, 8).Where(bit => (bits >> bit & 1) != 0)];
            Assert.Equal(expected, BitConverter.GetBytes(LanePlaces.Of(bits)).Take(expected.Length).Select(place => (int)place));
        }
    }

    /// <summary>A pencil whose apex is near to the origin, with the mesh in front of it.</summary>
    private static RayPencil Pencil(Random random, double scale, double spread) => new()
    {
        ApexX = scale * random.NextDouble(),
        ApexY = scale * random.NextDouble(),
        ApexZ = scale * random.NextDouble(),
        Shear = (8 * random.NextDouble()) - 4,
        MiddleX = (float)((2 * random.NextDouble()) - 1),
        MiddleY = (float)((2 * random.NextDouble()) - 1),
        SpreadX = spread * random.NextDouble(),
        SpreadY = spread * random.NextDouble(),
        Axis = random.Next(3),
        Sign = random.Next(2) == 0 ? 1 : -1,
        Size = 100 * scale,
        Nearest = 1e-4 * scale,
    };

    /// <summary>Three vertices, the first one near to some ray of the pencil.</summary>
    private static double[] Triangle(Random random, in RayPencil pencil, double scale, double size)
    {
        double[] numbers = new double[9];
        double depth = scale * (0.5 + (5 * random.NextDouble())), x = 0, y = 0, z = 0;
        for (int vertex = 0; vertex < 3; vertex++)
        {
            double slopeX = pencil.MiddleX + (1.2 * pencil.SpreadX * ((2 * random.NextDouble()) - 1)), slopeY = pencil.MiddleY + (pencil.Shear * slopeX) + (1.2 * pencil.SpreadY * ((2 * random.NextDouble()) - 1));
            (x, y, z) = vertex == 0
                ? (depth * slopeX, depth * slopeY, depth)
                : (x + (size * (random.NextDouble() - 0.5)), y + (size * (random.NextDouble() - 0.5)), z + (size * (random.NextDouble() - 0.5)));
            numbers[(3 * vertex) + ((pencil.Axis + 1) % 3)] = pencil.ApexX + x;
            numbers[(3 * vertex) + ((pencil.Axis + 2) % 3)] = pencil.ApexY + y;
            numbers[(3 * vertex) + pencil.Axis] = pencil.ApexZ + (pencil.Sign * z);
        }

        return numbers;
    }

    /// <summary>Checks four triangles.</summary>
    /// <returns>Of how many the apex is certainly on one side.</returns>
    private static int Check<F>(in RayPencil pencil, double[] numbers, bool isSingle)
        where F : unmanaged, IReal<F>
    {
        float[] columns = new float[PencilTriangles.Numbers * PencilTriangles.Room], vertices = new float[PencilTriangles.VertexNumbers * PencilTriangles.Room];
        fixed (float* column = columns, vertex = vertices)
        fixed (double* position = numbers)
        {
            MeshTriangle* triangles = stackalloc MeshTriangle[PencilTriangles.Most];
            for (int i = 0; i < PencilTriangles.Most; i++)
            {
                triangles[i] = new MeshTriangle(9 * i, (9 * i) + 3, (9 * i) + 6, i);
            }

            PencilTriangles.Load(pencil, triangles, PencilTriangles.Most, new MeshDoublePositions(position), vertex);
            PencilTriangles.Prepare<F>(pencil, isSingle, PencilTriangles.Most, vertex, column);
        }

        int known = 0;
        for (int i = 0; i < PencilTriangles.Most; i++)
        {
            int triangle = i;
            RayPencil own = pencil;
            known += Check(own, number => columns[(number * PencilTriangles.Room) + triangle], Seen(own, numbers.AsSpan(9 * i, 9))) ? 1 : 0;
        }

        return known;
    }

    /// <summary>Vertices as the pencil sees them: x, y, z each.</summary>
    private static double[] Seen(in RayPencil pencil, ReadOnlySpan<double> numbers)
    {
        double[] seen = new double[9];
        for (int vertex = 0; vertex < 3; vertex++)
        {
            double x = numbers[(3 * vertex) + ((pencil.Axis + 1) % 3)] - pencil.ApexX, y = numbers[(3 * vertex) + ((pencil.Axis + 2) % 3)] - pencil.ApexY;
            double z = (numbers[(3 * vertex) + pencil.Axis] - pencil.ApexZ) * pencil.Sign;
            (seen[3 * vertex], seen[(3 * vertex) + 1], seen[(3 * vertex) + 2]) = (x - (pencil.MiddleX * z), y - (pencil.Shear * x) - (pencil.MiddleY * z), z);
        }

        return seen;
    }

    private static bool Check(in RayPencil pencil, Func<int, float> at, double[] p)
    {
        double volume = Enumerable.Range(0, 3).Sum(vertex => p[(3 * vertex) + 2] * Edge(p, vertex, 0, 0));
        for (int vertex = 0; vertex < 3 && p[2] > pencil.Nearest && p[5] > pencil.Nearest && p[8] > pencil.Nearest; vertex++)
        {
            double x = p[3 * vertex] / p[(3 * vertex) + 2], y = p[(3 * vertex) + 1] / p[(3 * vertex) + 2];
            Assert.InRange(x, at(PencilTriangles.LowX), at(PencilTriangles.HighX));
            Assert.InRange(y, at(PencilTriangles.LowY), at(PencilTriangles.HighY));
        }

        if (float.IsNegativeInfinity(at(PencilTriangles.VolumeLow)))
        {
            return false;
        }

        Assert.InRange(Math.Abs(volume), at(PencilTriangles.VolumeLow), at(PencilTriangles.VolumeHigh));
        foreach ((double signX, double signY) in (ReadOnlySpan<(double, double)>)[(0, 0), (1, 1), (-1, 1), (1, -1), (-1, -1), (0.3, -0.7)])
        {
            // As a ray is tested.
            float slopeX = (float)(signX * pencil.SpreadX), slopeY = (float)(signY * pencil.SpreadY), sum = 0;
            double exactSum = 0;
            for (int edge = 0; edge < 3; edge++)
            {
                int first = edge * PencilTriangles.EdgeNumbers;
                float middle = MathF.FusedMultiplyAdd(slopeY, at(first + PencilTriangles.EdgeY), at(first + PencilTriangles.EdgeMiddle));
                float found = MathF.FusedMultiplyAdd(slopeX, at(first + PencilTriangles.EdgeX), middle);
                double exact = Edge(p, edge, slopeX, slopeY) * Math.Sign(volume);
                if (IsInside(p, slopeX, slopeY))
                {
                    Assert.InRange(exact, found - (Slack * at(first + PencilTriangles.EdgeError)), found);
                }

                (sum, exactSum) = (sum + found, exactSum + exact);
            }

            if (IsInside(p, slopeX, slopeY))
            {
                Assert.InRange(exactSum, sum - (Slack * at(PencilTriangles.SumError)), sum);
            }
        }

        return true;
    }

    /// <summary>Tells whether a ray meets a triangle, for which the bounds are promised.</summary>
    private static bool IsInside(double[] p, double x, double y)
    {
        double a = Edge(p, 0, x, y), b = Edge(p, 1, x, y), c = Edge(p, 2, x, y);
        return (a >= 0 && b >= 0 && c >= 0) || (a <= 0 && b <= 0 && c <= 0);
    }

    /// <summary>The edge function of the two vertices after one, which the pencil sees at some slopes.</summary>
    private static double Edge(double[] p, int edge, double x, double y)
    {
        int a = (edge + 1) % 3 * 3, b = (edge + 2) % 3 * 3;
        return ((p[a] - (x * p[a + 2])) * (p[b + 1] - (y * p[b + 2]))) - ((p[b] - (x * p[b + 2])) * (p[a + 1] - (y * p[a + 2])));
    }
}
