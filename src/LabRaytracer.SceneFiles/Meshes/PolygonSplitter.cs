namespace LabRaytracer;

/// <summary>Cuts faces with more than three corners into triangles.</summary>
internal static class PolygonSplitter
{
    /// <summary>Most corners of a polygon that is no fan: the time to cut one grows with the square of them, or faster.</summary>
    public const int MostCorners = 2048;

    /// <summary>Replaces the fan that stands for a polygon by triangles that lie inside it, also where it is concave.</summary>
    /// <remarks>
    /// Where all triangles of the fan go round the same way as the polygon, they cover it already (of a polygon that does not cross itself).
    /// Else ear clipping (Meisters 1975) on the plane of the polygon's area vector.
    /// </remarks>
    /// <param name="data">The numbers; the polygon's triangles are (c0, c1, c2), (c0, c2, c3), ...</param>
    /// <param name="triangle">First triangle of the fan.</param>
    /// <param name="corners">Number of corners, at least 4.</param>
    /// <returns>False if the polygon has too many corners to be cut.</returns>
    public static bool TrySplit(ObjData data, int triangle, int corners)
    {
        ObjCorner[] all = Corners(data, triangle, corners);
        (double X, double Y)[] flat = new (double X, double Y)[corners];
        if (!Flatten(data, all, flat) || IsFan(flat))
        {
            return true;
        }

        if (corners > MostCorners)
        {
            return false;
        }

        List<int> left = [.. Enumerable.Range(0, corners)];
        int at = 3 * triangle;
        while (left.Count > 3)
        {
            int ear = FindEar(flat, left);
            Set(data, at, all, left, ear);
            left.RemoveAt(ear);
            at += 3;
        }

        Set(data, at, all, left, 1);
        return true;
    }

    private static ObjCorner[] Corners(ObjData data, int triangle, int corners)
    {
        ObjCorner[] all = new ObjCorner[corners];
        all[0] = data.GetCorner(3 * triangle);
        all[1] = data.GetCorner((3 * triangle) + 1);
        for (int i = 2; i < corners; i++)
        {
            all[i] = data.GetCorner((3 * (triangle + i - 2)) + 2);
        }

        return all;
    }

    private static void Set(ObjData data, int at, ObjCorner[] all, List<int> left, int ear)
    {
        data.SetCorner(at, all[left[(ear + left.Count - 1) % left.Count]]);
        data.SetCorner(at + 1, all[left[ear]]);
        data.SetCorner(at + 2, all[left[(ear + 1) % left.Count]]);
    }

    /// <summary>Drops the coordinate in which the polygon is thinnest, so that it goes round counter-clockwise; false if it has no area.</summary>
    private static bool Flatten(ObjData data, ObjCorner[] corners, Span<(double X, double Y)> flat)
    {
        Point3D hub = data.Position(corners[0].Position);
        Vector3D area = Vector3D.Zero;
        for (int i = 1; i + 1 < corners.Length; i++)
        {
            area += Vector3D.Cross(data.Position(corners[i].Position) - hub, data.Position(corners[i + 1].Position) - hub);
        }

        double x = Math.Abs(area.X), y = Math.Abs(area.Y), z = Math.Abs(area.Z);
        for (int i = 0; i < corners.Length; i++)
        {
            Vector3D p = data.Position(corners[i].Position) - hub;
            flat[i] = x >= y && x >= z ? (p.Y, p.Z * Math.Sign(area.X)) : y >= z ? (p.Z, p.X * Math.Sign(area.Y)) : (p.X, p.Y * Math.Sign(area.Z));
        }

        return area.IsFinite && area != Vector3D.Zero;
    }

    private static bool IsFan(ReadOnlySpan<(double X, double Y)> flat)
    {
        bool fan = true;
        for (int i = 1; fan && i + 1 < flat.Length; i++)
        {
            fan = Turn(flat[0], flat[i], flat[i + 1]) > 0;
        }

        return fan;
    }

    /// <summary>The corner that can be cut off: convex, and no other corner inside. If rounding leaves none, the one that turns left most.</summary>
    private static int FindEar(ReadOnlySpan<(double X, double Y)> flat, List<int> left)
    {
        int best = 0;
        double most = double.NegativeInfinity;
        for (int i = 0; i < left.Count; i++)
        {
            int before = left[(i + left.Count - 1) % left.Count], corner = left[i], after = left[(i + 1) % left.Count];
            double turn = Turn(flat[before], flat[corner], flat[after]);
            if (turn > 0 && IsEmpty(flat, left, before, corner, after))
            {
                return i;
            }

            (best, most) = turn > most ? (i, turn) : (best, most);
        }

        return best;
    }

    private static bool IsEmpty(ReadOnlySpan<(double X, double Y)> flat, List<int> left, int a, int b, int c)
    {
        foreach (int other in left)
        {
            // Corners at the same place as one of the ear (bridges to holes) do not lie inside.
            if (other == a || other == b || other == c || flat[other] == flat[a] || flat[other] == flat[b] || flat[other] == flat[c])
            {
                continue;
            }

            if (Turn(flat[a], flat[b], flat[other]) >= 0 && Turn(flat[b], flat[c], flat[other]) >= 0 && Turn(flat[c], flat[a], flat[other]) >= 0)
            {
                return false;
            }
        }

        return true;
    }

    /// <summary>Twice the area of a triangle; positive counter-clockwise.</summary>
    private static double Turn((double X, double Y) a, (double X, double Y) b, (double X, double Y) c) =>
        ((b.X - a.X) * (c.Y - a.Y)) - ((b.Y - a.Y) * (c.X - a.X));
}
