using System.Runtime.CompilerServices;

namespace LabRaytracer;

/// <summary>A lamp at a point that shines into a cone (Polish: reflektor).</summary>
/// <remarks>
/// Immutable, thread safe. Full intensity inside the inner cone, none outside the outer one, in between a smooth step
/// s^2 (3 - 2 s) of the cosine of the angle to the axis.
/// </remarks>
public sealed class SpotLight : Light, IWideLight
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
    public Attenuation Attenuation { get; init => field = PropertyChecks.NotNull(value); } = Attenuation.None;

    /// <summary>Cosine of the outer angle.</summary>
    internal double CosOuter { get; }

    /// <summary>Cosine of the inner angle.</summary>
    internal double CosInner { get; }

    private Formula Own => new(this, Intensity);

    /// <inheritdoc/>
    public override bool TrySample(Point3D point, out LightSample sample) => LightFormulas.TrySample(Own, point, out sample);

    [MethodImpl(MethodImplOptions.NoInlining)]
    void IWideLight.Sample<R, F, I>(SurfaceBatch<R, F, I> surfaces, in LightColumns<R, F> samples, int packets) =>
        LightFormulas.Sample(Own, surfaces, samples, packets);

    private readonly record struct Formula(SpotLight Light, Intensity Intensity) : ILightFormula
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public void Sample<R>(R x, R y, R z, out LightLanes<R> sample)
            where R : unmanaged, IReal<R>
        {
            R away = LightFormulas.Towards(Light.Position, x, y, z, out sample);
            R cosine = -Lane.Dot(
                sample.DirectionX, sample.DirectionY, sample.DirectionZ, R.Of(Light.Direction.X), R.Of(Light.Direction.Y), R.Of(Light.Direction.Z));
            R step = Light.CosInner > Light.CosOuter
                ? R.Max(R.Min((cosine - R.Of(Light.CosOuter)) / R.Of(Light.CosInner - Light.CosOuter), R.Of(1)), R.Zero)
                : R.LessOrEqual(R.Of(Light.CosOuter), cosine) & R.Of(1);
            R share = step * step * R.Fma(R.Of(-2), step, R.Of(3));
            sample.Share = away & (share * LightFormulas.Fade(Light.Attenuation, sample.Distance));
        }
    }
}
