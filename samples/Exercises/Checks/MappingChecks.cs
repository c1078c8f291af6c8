using System.Globalization;

namespace Exercises;

/// <summary>Checks of mappings: null if all is right, else the first fault in words.</summary>
public static class MappingChecks
{
    private const double Tolerance = 1e-9;

    private static readonly Point3D[] s_square = [new(0, 0, 0), new(-1, 0, -1), new(1, 0, -1), new(-1, 0, 1), new(1, 0, 1), new(0.5, 0, -0.5), new(-0.3, 0, 0.8)];

    private static readonly Point3D[] s_around =
    [
        new(0, 0, 1), new(1, 0.5, 0), new(0, -0.5, -1), new(-1, 1, 0), new(0.6, -1, 0.8), new(0.6, 0.2, -0.8), new(-0.6, 0, -0.8), new(-0.6, 0.4, 0.8),
    ];

    private static readonly Point3D[] s_ball =
    [
        new(0, 0, 1), new(1, 0, 0), new(0, 0, -1), new(-1, 0, 0), new(0, 1, 0), new(0, -1, 0), new(0.48, 0.6, 0.64), new(-0.64, -0.6, -0.48), new(0.8, -0.6, 0),
    ];

    /// <summary>Exercise 1.</summary>
    public static string? Rectangular(IMapping mapping) =>
        First(mapping, new RectangularMapping(), s_square, (expected, got) =>
            IsNear(got.V, expected.V - 1) ? "That is the sheet's (x - 1)/2, a misprint: docs/errata.md, E1."
            : IsNear(got.U, expected.V) && IsNear(got.V, expected.U) ? "u and v are swapped."
            : "");

    /// <summary>Exercise 2.</summary>
    public static string? Cylindrical(IMapping mapping) => First(mapping, new CylindricalMapping(), s_around, Around);

    /// <summary>Exercise 3.</summary>
    public static string? Spherical(IMapping mapping)
    {
        SphericalMapping exact = new();
        return First(mapping, exact, s_ball, Around)
            ?? First(mapping, exact, [new Point3D(0, Math.BitIncrement(1), 0), new Point3D(0, -Math.BitIncrement(1), 0)], (_, _) => "|y| is a hair above 1 there: docs/errata.md, E6.")
            ?? First(mapping, exact, s_ball.Select(p => Point3D.Origin + (2.5 * p.ToVector())), (_, _) => "The radius is not 1 there: docs/errata.md, E7.");
    }

    private static string Around(TextureCoordinate expected, TextureCoordinate got)
    {
        double u = expected.U;
        return IsNear(got.V, 1 - expected.V) && !IsNear(expected.V, 0.5) ? "The picture is upside down: v goes up."
            : IsNear(got.U, u - 1) ? "Angles below 0 need a whole turn more."
            : IsNear(Turn(got.U), Turn(1 - u)) ? "The picture is mirrored: phi grows from +z towards +x."
            : IsNear(Turn(got.U), Turn(0.25 - u)) ? "x and z are swapped: phi = atan2(x, z)."
            : IsNear(Turn(got.U), Turn(u + 0.5)) ? "Opposite quadrants fall together: Math.Atan2 tells them apart, Math.Atan does not: docs/errata.md, E2."
            : double.IsNaN(got.U) || double.IsNaN(got.V) ? "Not a number: which operation has no result there?"
            : "";
    }

    private static string? First(IMapping mapping, IMapping exact, IEnumerable<Point3D> points, Func<TextureCoordinate, TextureCoordinate, string> name)
    {
        foreach (Point3D point in points)
        {
            SurfacePosition position = new(point, default, default);
            TextureCoordinate expected = exact.Map(position), got = mapping.Map(position);
            if (!IsNear(expected.U, got.U) || !IsNear(expected.V, got.V))
            {
                return string.Create(
                    CultureInfo.InvariantCulture,
                    $"at ({point.X}, {point.Y}, {point.Z}) the result should be ({expected.U:0.######}, {expected.V:0.######}), it is ({got.U:0.######}, {got.V:0.######}). {name(expected, got)}").TrimEnd();
            }
        }

        return null;
    }

    private static double Turn(double u) => u - Math.Floor(u);

    private static bool IsNear(double a, double b) => Math.Abs(a - b) <= Tolerance;
}
