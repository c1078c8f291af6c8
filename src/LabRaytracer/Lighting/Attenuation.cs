namespace LabRaytracer;

/// <summary>How light fades with distance d: 1 / (constant + linear d + quadratic d^2).</summary>
/// <remarks>Immutable, thread safe. <see cref="None"/> (1, 0, 0) does not fade.</remarks>
public sealed class Attenuation
{
    /// <summary>Creates an attenuation.</summary>
    /// <param name="constant">Constant term, at least 0.</param>
    /// <param name="linear">Factor of the distance, per scene unit, at least 0.</param>
    /// <param name="quadratic">Factor of the squared distance, per squared scene unit, at least 0.</param>
    /// <exception cref="ArgumentOutOfRangeException">A factor is negative or not finite, or all are 0.</exception>
    public Attenuation(double constant, double linear, double quadratic)
    {
        if (!(constant >= 0 && linear >= 0 && quadratic >= 0) || !(constant + linear + quadratic > 0) || !double.IsFinite(constant + linear + quadratic))
        {
            throw new ArgumentOutOfRangeException(
                nameof(constant), $"({constant}, {linear}, {quadratic})", "The factors of an attenuation must be finite, at least 0, and not all 0.");
        }

        Constant = constant;
        Linear = linear;
        Quadratic = quadratic;
    }

    /// <summary>No fading.</summary>
    public static Attenuation None { get; } = new(1, 0, 0);

    /// <summary>Constant term.</summary>
    public double Constant { get; }

    /// <summary>Factor of the distance, per scene unit.</summary>
    public double Linear { get; }

    /// <summary>Factor of the squared distance, per squared scene unit.</summary>
    public double Quadratic { get; }

    /// <summary>Tells whether light does not fade.</summary>
    public bool IsNone => Constant == 1 && Linear == 0 && Quadratic == 0;

    /// <summary>The factor at a distance, (0, +inf].</summary>
    /// <param name="distance">Distance, scene units, at least 0.</param>
    public double At(double distance) => 1 / Math.FusedMultiplyAdd(Math.FusedMultiplyAdd(Quadratic, distance, Linear), distance, Constant);
}
