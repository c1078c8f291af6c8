using System.Globalization;

namespace LabRaytracer;

/// <summary>Validation of what a mesh is made of.</summary>
internal static class MeshChecks
{
    /// <summary>Coordinates beyond this would overflow in the floats of the tree of boxes.</summary>
    private const double LargestCoordinate = 1e18;

    private const int Chunk = 1 << 16;

    /// <summary>Throws if any number is out of range.</summary>
    public static void Validate(ReadOnlySpan<double> positions, ReadOnlySpan<int> corners, MeshOptions options)
    {
        if (corners.IsEmpty || corners.Length % 3 != 0)
        {
            throw new ArgumentException(Text($"A mesh needs 3 vertex numbers a triangle and at least one triangle; got {corners.Length} numbers."), nameof(corners));
        }

        Tuples("positions", positions, 3, LargestCoordinate);
        Tuples("normals", options.Normals.Span, 3, LargestCoordinate);
        Tuples("texture coordinates", options.TextureCoordinates.Span, 2, double.MaxValue);
        Corners("positions", corners, corners.Length, positions.Length / 3);
        Attribute("normals", corners, options.NormalCorners.Span, options.Normals.Length / 3);
        Attribute("texture coordinates", corners, options.TextureCorners.Span, options.TextureCoordinates.Length / 2);
        if (!Enum.IsDefined(options.DegenerateTriangles))
        {
            throw new ArgumentException(Text($"DegenerateTriangles must be Reject or Drop; got {options.DegenerateTriangles}."), nameof(options));
        }
    }

    /// <summary>The triangles that have an area; throws on the first one without where they are rejected.</summary>
    /// <returns>Their numbers, or null for all.</returns>
    public static int[]? KeptTriangles(MeshData mesh, DegenerateTriangles policy)
    {
        if (AllHaveArea(mesh))
        {
            return null;
        }

        List<int>? kept = null;
        for (int triangle = 0; triangle < mesh.TriangleCount; triangle++)
        {
            if (HasArea(mesh, triangle))
            {
                kept?.Add(triangle);
                continue;
            }

            if (policy == DegenerateTriangles.Reject)
            {
                throw new ArgumentException(Text(
                    $"Triangle {triangle} has no area: {mesh.Position(triangle, 0)}, {mesh.Position(triangle, 1)}, {mesh.Position(triangle, 2)}. Remove it, or set MeshOptions.DegenerateTriangles to Drop."));
            }

            kept ??= [.. Enumerable.Range(0, triangle)];
        }

        return kept?.ToArray();
    }

    private static bool AllHaveArea(MeshData mesh)
    {
        bool all = true;
        ChunkLoop.Run(mesh.TriangleCount, Chunk, Environment.ProcessorCount, (first, end) =>
        {
            for (int triangle = first; triangle < end; triangle++)
            {
                if (!HasArea(mesh, triangle))
                {
                    Volatile.Write(ref all, false);
                    return;
                }
            }
        });
        return all;
    }

    private static bool HasArea(MeshData mesh, int triangle)
    {
        Point3D a = mesh.Position(triangle, 0);
        return Vector3D.Cross(mesh.Position(triangle, 1) - a, mesh.Position(triangle, 2) - a) != Vector3D.Zero;
    }

    private static void Tuples(string what, ReadOnlySpan<double> numbers, int size, double largest)
    {
        if (numbers.Length % size != 0)
        {
            throw new ArgumentException(Text($"The {what} of a mesh are groups of {size} numbers; got {numbers.Length} numbers."));
        }

        for (int i = 0; i < numbers.Length; i++)
        {
            if (!(Math.Abs(numbers[i]) <= largest))
            {
                throw new ArgumentException(Text($"Number {i % size} of the {what} at {i / size} is {numbers[i]}; it must be finite, at most {largest} in magnitude."));
            }
        }
    }

    private static void Attribute(string what, ReadOnlySpan<int> corners, ReadOnlySpan<int> own, int count)
    {
        if (count == 0 && own.IsEmpty)
        {
            return;
        }

        Corners(what, own.IsEmpty ? corners : own, corners.Length, count);
    }

    private static void Corners(string what, ReadOnlySpan<int> numbers, int expected, int count)
    {
        if (numbers.Length != expected)
        {
            throw new ArgumentException(Text($"The mesh has {expected / 3} triangles and needs {expected} numbers of {what}; got {numbers.Length}."));
        }

        for (int i = 0; i < numbers.Length; i++)
        {
            if ((uint)numbers[i] >= (uint)count)
            {
                throw new ArgumentException(Text($"Corner {i % 3} of triangle {i / 3} names {what} number {numbers[i]}; allowed: 0 to {count - 1}."));
            }
        }
    }

    private static string Text(FormattableString text) => text.ToString(CultureInfo.InvariantCulture);
}
