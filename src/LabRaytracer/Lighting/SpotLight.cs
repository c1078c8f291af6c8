namespace LabRaytracer;

/// <summary>A lamp at a point that shines into a cone (Polish: reflektor).</summary>
/// <remarks>
/// Immutable, thread safe. Full intensity inside the inner cone, none outside the outer one, in between a smooth step
/// s^2 (3 - 2 s) of the cosine of the angle to the axis.
/// </remarks>
public sealed class SpotLight : Light
{
    /// <summary>Creates a spot light.</summary>
    /// <param name="position">Position, world space; finite.</param>
    /// <param name="target">A point that the axis goes through, world space; finite, not the position.</param>
    /// <param name="intensity">Linear intensity; finite, not negative.</param>
    /// <param name="outerDegrees">Angle between the axis and the edge of the cone, degrees, (0, 90].</param>
    /// <param name="innerDegrees">Angle between the axis and the edge of full light, degrees, [0, outer].</param>
    /// <exception cref="ArgumentOutOfRangeException">An argument is outside its range.</exception>
    public SpotLight(Point3D position, Point3D target, Intensity intensity, double outerDegrees, double innerDegrees)
    {
        Position = LightChecks.Position(position);
        Direction = LightChecks.Direction(target - position, nameof(target));
        Intensity = LightChecks.Intensity(intensity);
        if (!(outerDegrees is > 0 and <= 90))
        {
            throw new ArgumentOutOfRangeException(nameof(outerDegrees), outerDegrees, "The outer angle of a spot light must be in (0, 90] degrees.");
        }

        if (!(innerDegrees >= 0 && innerDegrees <= outerDegrees))
        {
            throw new ArgumentOutOfRangeException(nameof(innerDegrees), innerDegrees, $"The inner angle of a spot light must be in [0, {outerDegrees}] degrees, its outer angle.");
        }

        OuterDegrees = outerDegrees;
        InnerDegrees = innerDegrees;
        CosOuter = Elementary.SinCosDegrees(outerDegrees).Cos;
        CosInner = Elementary.SinCosDegrees(innerDegrees).Cos;
    }

    /// <summary>Position, world space.</summary>
    public Point3D Position { get; }

    /// <summary>Axis, world space, length 1.</summary>
    public Vector3D Direction { get; }

    /// <summary>Linear intensity inside the inner cone, at least 0.</summary>
    public Intensity Intensity { get; }

    /// <summary>Angle between the axis and the edge of the cone, degrees, (0, 90].</summary>
    public double OuterDegrees { get; }

    /// <summary>Angle between the axis and the edge of full light, degrees, [0, <see cref="OuterDegrees"/>].</summary>
    public double InnerDegrees { get; }

    /// <summary>How the light fades with distance. Default: not at all.</summary>
    public Attenuation Attenuation { get; init; } = Attenuation.None;

    /// <summary>Cosine of the outer angle.</summary>
    internal double CosOuter { get; }

    /// <summary>Cosine of the inner angle.</summary>
    internal double CosInner { get; }

    /// <inheritdoc/>
    public override bool TrySample(Point3D point, out LightSample sample)
    {
        Vector3D toLight = Position - point;
        double distance = Math.Sqrt(toLight.LengthSquared);
        Vector3D direction = toLight / distance;
        double cos = -Vector3D.Dot(direction, Direction);
        double step = CosInner > CosOuter ? Math.Clamp((cos - CosOuter) / (CosInner - CosOuter), 0, 1) : cos >= CosOuter ? 1 : 0;
        double share = step * step * (3 - (2 * step));
        sample = new LightSample(direction, distance, Intensity * (float)(share * Attenuation.At(distance)));
        return distance > 0 && share > 0;
    }
}
