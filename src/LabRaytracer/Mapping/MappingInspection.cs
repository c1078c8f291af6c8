using System.Globalization;

namespace LabRaytracer;

/// <summary>The checks of a <see cref="MappingReport"/>.</summary>
internal sealed class MappingInspection(IMapping mapping)
{
    private const int Points = 2000, Circles = 40, StepsAround = 500;

    private Vector3D? _seam;

    /// <summary>Faults found.</summary>
    public List<string> Faults { get; } = [];

    /// <summary>Facts found.</summary>
    public List<string> Facts { get; } = [];

    /// <summary>Runs all checks. A mapping that gives no numbers is not looked at any further.</summary>
    public void Run()
    {
        Vector3D[] sphere = [.. Enumerable.Range(0, Points).Select(Spread)];
        if (!IsFinite([.. Extremes(), .. sphere]))
        {
            return;
        }

        Walk();
        Range(sphere);
        Orientation(sphere);
        Gradients(sphere);
        Scale(sphere);
        Facts.Add($"poles: {Text(Map(new Vector3D(0, 1, 0)))} at (0, 1, 0), {Text(Map(new Vector3D(0, -1, 0)))} at (0, -1, 0)");
    }

    /// <summary>Point i of a spiral that covers the sphere evenly: equal steps of height, the golden angle between neighbours.</summary>
    private static Vector3D Spread(int i)
    {
        double y = 1 - ((2 * i) + 1.0) / Points, radius = Math.Sqrt(1 - (y * y));
        (double sin, double cos) = Elementary.SinCosDegrees(i * 137.50776405003785);
        return new Vector3D(radius * sin, y, radius * cos);
    }

    /// <summary>Poles, axes, the origin, points a rounding off the sphere, far and near ones.</summary>
    private static IEnumerable<Vector3D> Extremes()
    {
        double[] numbers = [0, 1, -1, Math.BitIncrement(1), -Math.BitIncrement(1), 1e-17, -1e-17, 1e-300, 1e150];
        return from x in numbers from y in numbers from z in numbers select new Vector3D(x, y, z);
    }

    private bool IsFinite(Vector3D[] points)
    {
        foreach (Vector3D point in points)
        {
            TextureCoordinate at = Map(point), again = Map(point);
            if (!double.IsFinite(at.U) || !double.IsFinite(at.V))
            {
                Faults.Add($"finite: {Text(at)} at {Text(point)}; allowed: finite numbers");
                return false;
            }

            if (at != again)
            {
                Faults.Add($"repeatable: {Text(at)}, then {Text(again)} at {Text(point)}; allowed: the same twice");
                return false;
            }
        }

        return true;
    }

    private void Range(Vector3D[] points)
    {
        foreach (Vector3D point in points.Concat([new(0, 0, 1), new(0, 0, -1), new(1, 0, 0), new(-1, 0, 0), new(0, 1, 0), new(0, -1, 0), new(-1e-17, 0, 1)]))
        {
            TextureCoordinate at = Map(point);
            bool isPastSeam = _seam is not null && at.U == 1;
            if (isPastSeam || !(at.U is >= 0 and <= 1 && at.V is >= 0 and <= 1))
            {
                Faults.Add($"range: {Text(at)} at {Text(point)}; allowed: {(isPastSeam ? "u below 1, where the picture begins again" : "u and v from 0 to 1")}");
                return;
            }
        }
    }

    /// <summary>Looks for jumps along great circles.</summary>
    private void Walk()
    {
        Vector3D? jump = null;
        for (int circle = 0; circle < Circles; circle++)
        {
            Vector3D first = Spread((circle * 47) + 13), second = Vector3D.Cross(first, Spread((circle * 31) + 700)).Normalized();
            Vector3D before = first;
            for (int step = 1; step <= StepsAround; step++)
            {
                (double sin, double cos) = Elementary.SinCosDegrees(step * 360.0 / StepsAround);
                Vector3D here = (first * cos) + (second * sin);
                Narrow(before, here, ref jump);
                before = here;
            }
        }

        if (jump is { } at)
        {
            Faults.Add($"continuity: (u, v) jumps at {Text(at)}; allowed: jumps by whole turns");
        }

        Facts.Add(_seam is { } seam ? $"seam: u jumps by a turn, for instance at {Text(seam)}" : "seam: none found");
    }

    /// <summary>Follows a suspicious step down to where it happens; notes whether it is a seam or a jump.</summary>
    private void Narrow(Vector3D low, Vector3D high, ref Vector3D? jump)
    {
        if (Gap(low, high, isWhole: false) < 0.02 && Gap(low, high, isWhole: true) < 0.5)
        {
            return;
        }

        for (int i = 0; i < 40; i++)
        {
            Vector3D middle = (low + high) / 2;
            bool isLower = Gap(low, middle, isWhole: true) >= Gap(middle, high, isWhole: true);
            (low, high) = isLower ? (low, middle) : (middle, high);
        }

        if (Gap(low, high, isWhole: false) > 0.01)
        {
            jump ??= high;
        }
        else if (Gap(low, high, isWhole: true) > 0.5)
        {
            _seam ??= high;
        }
    }

    /// <summary>How far (u, v) of two points are apart; whole turns count or not.</summary>
    private double Gap(Vector3D a, Vector3D b, bool isWhole)
    {
        TextureCoordinate first = Map(a), second = Map(b);
        double u = second.U - first.U, v = second.V - first.V;
        return isWhole ? Math.Abs(u) + Math.Abs(v) : Math.Abs(u - Math.Round(u)) + Math.Abs(v - Math.Round(v));
    }

    private void Orientation(Vector3D[] points)
    {
        Vector3D? upright = null, mirrored = null;
        foreach (Vector3D point in points)
        {
            MappingGradient gradient = mapping.Gradient(Position(point));
            double area = Vector3D.Dot(Vector3D.Cross(gradient.U, gradient.V), point);
            upright ??= area > 1e-6 ? point : null;
            mirrored ??= area < -1e-6 ? point : null;
        }

        if (upright is { } good && mirrored is { } bad)
        {
            Faults.Add($"orientation: mirrored at {Text(bad)}, but not at {Text(good)}; allowed: the same everywhere");
        }
        else
        {
            Facts.Add(mirrored is null ? "orientation: not mirrored seen from outside" : "orientation: mirrored seen from outside");
        }
    }

    private void Gradients(Vector3D[] points)
    {
        foreach (Vector3D point in points)
        {
            MappingGradient own = mapping.Gradient(Position(point)), differences = MappingDifferences.Gradient(mapping, Position(point));
            double size = Math.Max(own.U.Length + own.V.Length, differences.U.Length + differences.V.Length);
            double error = (own.U - differences.U).Length + (own.V - differences.V).Length;
            if (!(error <= 1e-4 * Math.Max(size, 1)))
            {
                Faults.Add($"gradient: wrong by {error.ToString("g3", CultureInfo.InvariantCulture)} at {Text(point)}; allowed: what differences of Map give");
                return;
            }
        }
    }

    private void Scale(Vector3D[] points)
    {
        foreach (Vector3D point in points)
        {
            if (Gap(point, point * 3, isWhole: false) > 1e-9)
            {
                Facts.Add($"scale: the distance from the origin matters, for instance along {Text(point)}");
                return;
            }
        }

        Facts.Add("scale: the distance from the origin does not matter");
    }

    private TextureCoordinate Map(Vector3D point) => mapping.Map(Position(point));

    private static SurfacePosition Position(Vector3D point)
    {
        double length = point.Length;
        return new SurfacePosition(Point3D.Origin + point, length > 0 && double.IsFinite(length) ? point / length : Vector3D.UnitY, default) { WorldPoint = Point3D.Origin + point };
    }

    private static string Text(TextureCoordinate at) => string.Create(CultureInfo.InvariantCulture, $"(u, v) = ({at.U:g6}, {at.V:g6})");

    private static string Text(Vector3D point) => string.Create(CultureInfo.InvariantCulture, $"({point.X:g4}, {point.Y:g4}, {point.Z:g4})");
}
