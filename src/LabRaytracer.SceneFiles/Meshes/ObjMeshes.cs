namespace LabRaytracer;

/// <summary>Makes meshes of the numbers of an OBJ file: one for each material.</summary>
internal static class ObjMeshes
{
    /// <summary>The meshes in the order of their first triangles.</summary>
    public static IReadOnlyList<ObjPart> Make(ObjReader lines, IReadOnlyDictionary<string, Material> materials)
    {
        ObjData data = lines.Data;
        double[] normals = WithFaceNormals(data);
        double[] uvs = WithOrigin(data);
        List<(string Name, List<(int From, int To)> Runs)> parts = Runs(lines);
        List<ObjPart> made = new(parts.Count);
        foreach ((string name, List<(int From, int To)> runs) in parts)
        {
            bool whole = runs.Count == 1 && runs[0] == (0, data.Counts.Triangles);
            made.Add(new ObjPart(name, whole ? Whole(data, uvs, normals) : Part(data, uvs, normals, runs), materials.GetValueOrDefault(name)));
        }

        return made;
    }

    // One material may come and go: its runs of triangles are put together.
    private static List<(string Name, List<(int From, int To)> Runs)> Runs(ObjReader lines)
    {
        List<(string Name, List<(int From, int To)> Runs)> parts = [];
        Dictionary<string, int> numbers = new(StringComparer.Ordinal);
        int from = 0;
        string name = "";
        foreach ((int triangle, string next, _) in lines.Materials.Append((lines.Data.Counts.Triangles, "", 0)))
        {
            if (triangle > from)
            {
                if (numbers.TryAdd(name, parts.Count))
                {
                    parts.Add((name, []));
                }

                parts[numbers[name]].Runs.Add((from, triangle));
            }

            (from, name) = (triangle, next);
        }

        return parts;
    }

    /// <summary>The normals; triangles with a corner that has none, or one without direction, get the normal of their plane.</summary>
    private static double[] WithFaceNormals(ObjData data)
    {
        int[] of = data.NormalOf;
        if (of.AsSpan().IndexOfAnyInRange(int.MinValue, -1) < 0 && Enumerable.Range(0, data.Normals.Length / 3).All(normal => HasNormal(data, normal)))
        {
            return data.Normals;
        }

        List<double> added = [];
        for (int at = 0; at < of.Length; at += 3)
        {
            if (HasNormal(data, of[at]) && HasNormal(data, of[at + 1]) && HasNormal(data, of[at + 2]))
            {
                continue;
            }

            Point3D a = data.Position(data.PositionOf[at]);
            Vector3D normal = Vector3D.Cross(data.Position(data.PositionOf[at + 1]) - a, data.Position(data.PositionOf[at + 2]) - a);
            normal = normal == Vector3D.Zero || !normal.IsFinite ? Vector3D.UnitY : normal.Normalized();
            int number = (data.Normals.Length + added.Count) / 3;
            added.AddRange([normal.X, normal.Y, normal.Z]);
            (of[at], of[at + 1], of[at + 2]) = (number, number, number);
        }

        return added.Count == 0 ? data.Normals : [.. data.Normals, .. added];
    }

    private static bool HasNormal(ObjData data, int normal) => normal >= 0
        && (data.Normals[3 * normal] != 0 || data.Normals[(3 * normal) + 1] != 0 || data.Normals[(3 * normal) + 2] != 0);

    /// <summary>The texture coordinates; corners that have none get (0, 0).</summary>
    private static double[] WithOrigin(ObjData data)
    {
        int[] of = data.UvOf;
        int origin = data.Uvs.Length / 2;
        bool missing = false;
        for (int at = 0; at < of.Length; at++)
        {
            missing |= of[at] < 0;
            of[at] = of[at] < 0 ? origin : of[at];
        }

        return missing ? [.. data.Uvs, 0, 0] : data.Uvs;
    }

    private static TriangleMesh Whole(ObjData data, double[] uvs, double[] normals) => new(data.Positions, data.PositionOf, new MeshOptions
    {
        Normals = data.NormalOf.Length > 0 ? normals : default,
        NormalCorners = data.NormalOf,
        TextureCoordinates = data.UvOf.Length > 0 ? uvs : default,
        TextureCorners = data.UvOf,
        DegenerateTriangles = DegenerateTriangles.Drop,
    });

    private static TriangleMesh Part(ObjData data, double[] uvs, double[] normals, List<(int From, int To)> runs)
    {
        (double[] positions, int[] positionOf) = Subset(data.Positions, 3, data.PositionOf, runs);
        (double[] partNormals, int[] normalOf) = Subset(normals, 3, data.NormalOf, runs);
        (double[] partUvs, int[] uvOf) = Subset(uvs, 2, data.UvOf, runs);
        return new TriangleMesh(positions, positionOf, new MeshOptions
        {
            Normals = partNormals, NormalCorners = normalOf, TextureCoordinates = partUvs, TextureCorners = uvOf, DegenerateTriangles = DegenerateTriangles.Drop,
        });
    }

    /// <summary>The numbers that some triangles use, in the order of their first use, and the indices of them.</summary>
    private static (double[] Numbers, int[] Of) Subset(double[] numbers, int size, int[] of, List<(int From, int To)> runs)
    {
        if (of.Length == 0)
        {
            return ([], []);
        }

        Dictionary<int, int> renumbered = [];
        List<double> used = [];
        List<int> result = [];
        foreach (int index in runs.SelectMany(run => Enumerable.Range(3 * run.From, 3 * (run.To - run.From))).Select(at => of[at]))
        {
            if (!renumbered.TryGetValue(index, out int number))
            {
                number = renumbered.Count;
                renumbered.Add(index, number);
                used.AddRange(numbers.AsSpan(index * size, size));
            }

            result.Add(number);
        }

        return ([.. used], [.. result]);
    }
}
