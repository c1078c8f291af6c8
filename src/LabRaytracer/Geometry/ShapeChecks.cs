using System.Runtime.CompilerServices;

namespace LabRaytracer;

/// <summary>What shapes check of their arguments.</summary>
internal static class ShapeChecks
{
    /// <summary>A point with finite coordinates.</summary>
    public static Point3D Finite(Point3D value, string what, [CallerArgumentExpression(nameof(value))] string? name = null) =>
        value.IsFinite ? value : throw new ArgumentOutOfRangeException(name, value, $"The {what} needs finite coordinates.");

    /// <summary>A finite number above 0.</summary>
    public static double Positive(double value, string what, [CallerArgumentExpression(nameof(value))] string? name = null) =>
        value > 0 && double.IsFinite(value) ? value : throw new ArgumentOutOfRangeException(name, value, $"The {what} must be finite and above 0.");

    /// <summary>A direction of any finite length above 0, made length 1.</summary>
    public static Vector3D Direction(Vector3D value, string what, [CallerArgumentExpression(nameof(value))] string? name = null) =>
        value.IsFinite && value != Vector3D.Zero
            ? value.Normalized()
            : throw new ArgumentOutOfRangeException(name, value, $"The {what} needs a finite length above 0.");

    /// <summary>The unit normal a x b of the area between two vectors.</summary>
    /// <exception cref="ArgumentException">They span none.</exception>
    public static Vector3D Area(Vector3D a, Vector3D b, string message)
    {
        if (a == Vector3D.Zero || b == Vector3D.Zero || !double.IsFinite(a.Length) || !double.IsFinite(b.Length))
        {
            throw new ArgumentException(message);
        }

        // Unit vectors keep the product of very long or very short edges in range. Below 1e-15 nothing but rounding is left of the angle.
        Vector3D normal = Vector3D.Cross(a.Normalized(), b.Normalized());
        return normal.Length > 1e-15 ? normal.Normalized() : throw new ArgumentException(message);
    }
}
