using System.Runtime.CompilerServices;

namespace LabRaytracer;

/// <summary>What every lamp checks of its arguments.</summary>
internal static class LightChecks
{
    /// <summary>An intensity that is finite and not negative.</summary>
    public static Intensity Intensity(Intensity value, [CallerArgumentExpression(nameof(value))] string? name = null) =>
        value.IsFinite && value.R >= 0 && value.G >= 0 && value.B >= 0
            ? value
            : throw new ArgumentOutOfRangeException(name, value, "A light's intensity must be finite and at least 0 in every channel.");

    /// <summary>A finite position.</summary>
    public static Point3D Position(Point3D value, [CallerArgumentExpression(nameof(value))] string? name = null) =>
        value.IsFinite ? value : throw new ArgumentOutOfRangeException(name, value, "A light's position needs finite coordinates.");

    /// <summary>A direction of any finite length above 0, made length 1.</summary>
    public static Vector3D Direction(Vector3D value, [CallerArgumentExpression(nameof(value))] string? name = null) =>
        value.IsFinite && value != Vector3D.Zero
            ? value.Normalized()
            : throw new ArgumentOutOfRangeException(name, value, "A light's direction needs a finite length above 0.");

    /// <summary>A number of samples at each point.</summary>
    public static int Samples(int value, [CallerArgumentExpression(nameof(value))] string? name = null) => value is >= 1 and <= QuadLight.MaxSamples
        ? value
        : throw new ArgumentOutOfRangeException(name, value, $"The samples of a light at each point must be in [1, {QuadLight.MaxSamples}].");

    /// <summary>A transform that only rotates.</summary>
    public static Transform Rotation(Transform value, [CallerArgumentExpression(nameof(value))] string? name = null)
    {
        ArgumentNullException.ThrowIfNull(value, name);
        return value.IsRotation
            ? value
            : throw new ArgumentException("The surroundings can only be rotated: a transform made by Transform.Rotation, or several of them.", name);
    }
}
