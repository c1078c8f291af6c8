namespace LabRaytracer.Validation;

/// <summary>Ray parameters and weights of triangles against exact arithmetic, as parts of their running error bound (<see cref="TriangleBound"/>).</summary>
internal sealed class TriangleSweep(StressOptions options)
{
    private const int TrianglesPerPart = 100, RaysPerTriangle = 32;

    private static readonly string[] s_kinds = ["generic", "slivers", "almost edge-on", "far"];

    /// <summary>All lines of the table.</summary>
    public IEnumerable<StressRow> Run() => s_kinds.SelectMany(Run<Double16, Float16, Int16>).Concat(s_kinds.SelectMany(Run<Float16, Float16, Int16>));

    private List<StressRow> Run<R, F, I>(string kind)
        where R : unmanaged, ILane<R, F, I>
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I>
    {
        string format = R.IsSingle ? "float" : "double";
        Worst t = new($"triangle, {kind}: t, {format}", 1, "of its error bound"), weights = new($"triangle, {kind}: weights, {format}", 1, "of their error bound");
        Worst decisions = new($"triangle, {kind}: wrong hit or miss beyond the error bound, {format}", 0, "");
        Parallel.For(0, options.Parts(100), part =>
        {
            Draws draws = Draws.Of(options.Seed, "triangle" + kind + format, part);
            for (int i = 0; i < TrianglesPerPart; i++)
            {
                Point3D[] vertices = Vertices(draws, kind, R.IsSingle);
                Ray[] rays = [.. Enumerable.Range(0, RaysPerTriangle).Select(_ => At(draws, kind, vertices, R.IsSingle))];
                using RayRun<R, F, I> run = new(new Triangle(vertices[0], vertices[1], vertices[2]), Transform.Identity, rays);
                run.Surface();
                for (int ray = 0; ray < rays.Length; ray++)
                {
                    Note(run, ray, new ExactTriangle(rays[ray], vertices), vertices, rays[ray], t, weights, decisions);
                }
            }
        });
        return [decisions.ToRow(), t.ToRow(), weights.ToRow()];
    }

    private static void Note<R, F, I>(
        RayRun<R, F, I> run, int number, in ExactTriangle exact, Point3D[] vertices, in Ray ray, Worst t, Worst weights, Worst decisions)
        where R : unmanaged, ILane<R, F, I>
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I>
    {
        if (exact.Sum == 0)
        {
            return;
        }

        TriangleBound bound = new(exact, ray, vertices, R.IsSingle);
        double sign = Math.Sign(exact.Sum), time = exact.T.ToDouble();
        bool isInside = true, isOutside = time < -bound.T;
        for (int k = 0; k < 3; k++)
        {
            isInside &= sign * exact.Edges[k] > bound.Edges[k];
            isOutside |= sign * exact.Edges[k] < -bound.Edges[k];
        }

        string at = FormattableString.Invariant($"{vertices[0]} {vertices[1]} {vertices[2]} {ray}");
        if ((isInside && time > bound.T) || isOutside)
        {
            decisions.Count(run.IsHit(number) != isOutside, $"{at}, t {time:R}");
        }

        if (isInside && time > bound.T && run.IsHit(number))
        {
            t.Note(Math.Abs((run.Distance(number) - exact.T).ToDouble()) / bound.T, $"{at}, t {time:R}");
            (double b, double c) = run.SurfaceCoordinates(number);
            weights.Note(
                Math.Max(Math.Abs((b - exact.Weights[1]).ToDouble()) / bound.Weights[1], Math.Abs((c - exact.Weights[2]).ToDouble()) / bound.Weights[2]), $"{at}");
        }
    }

    private static Point3D[] Vertices(Draws draws, string kind, bool isSingle)
    {
        double size = draws.Scale(-3, 3);
        Point3D center = Point3D.Origin + (draws.Direction() * (size * draws.Scale(-1, 2)));
        Vector3D first = draws.Direction() * size, second = draws.Direction() * size;
        if (kind == "slivers")
        {
            second = (first * draws.Number(0.2, 0.8)) + (draws.Across(first.Normalized()) * (size * draws.Scale(isSingle ? -5 : -12, -3)));
        }

        return [Rounded(center, isSingle), Rounded(center + first, isSingle), Rounded(center + second, isSingle)];
    }

    private static Ray At(Draws draws, string kind, Point3D[] vertices, bool isSingle)
    {
        // Half of the rays of slivers would miss; all are aimed a little beyond the edges elsewhere.
        double reach = kind == "slivers" ? 0 : 0.1, b = draws.Number(-reach, 1), c = draws.Number(-reach, 1 - Math.Max(b, 0));
        Vector3D first = vertices[1] - vertices[0], second = vertices[2] - vertices[0];
        Point3D target = vertices[0] + (first * b) + (second * c);
        double size = first.Length, distance = size * (kind == "far" ? draws.Scale(3, isSingle ? 5 : 12) : draws.Scale(-1, 1.5));
        Vector3D away = draws.Direction();
        if (kind == "almost edge-on")
        {
            Vector3D along = ((first * draws.Number(-1, 1)) + (second * draws.Number(-1, 1))).Normalized();
            away = along + (Vector3D.Cross(first, second).Normalized() * (draws.Sign() * draws.Scale(isSingle ? -4 : -11, -2)));
        }

        Point3D from = Rounded(target + (away * distance), isSingle);
        Vector3D direction = target - from;
        direction = direction == Vector3D.Zero ? away : direction.Normalized();
        return new Ray(from, isSingle ? new Vector3D((float)direction.X, (float)direction.Y, (float)direction.Z) : direction);
    }

    private static Point3D Rounded(Point3D p, bool isSingle) => isSingle ? new Point3D((float)p.X, (float)p.Y, (float)p.Z) : p;
}
