using System.Runtime.CompilerServices;

namespace LabRaytracer;

/// <summary>Parallel light from infinitely far away, such as the sun (Polish: światło kierunkowe).</summary>
/// <remarks>Immutable, thread safe.</remarks>
public sealed class DirectionalLight : Light, IWideLight
{
    /// <summary>Creates directional light.</summary>
    /// <param name="direction">Direction in which the light travels, world space; any finite length above 0.</param>
    /// <param name="intensity">Linear intensity; finite, not negative.</param>
    /// <exception cref="ArgumentOutOfRangeException">The direction has no length, or the intensity is negative or not finite.</exception>
    public DirectionalLight(Vector3D direction, Intensity intensity)
    {
        Direction = LightChecks.Direction(direction);
        Intensity = LightChecks.Intensity(intensity);
    }

    /// <summary>Direction in which the light travels, world space, length 1.</summary>
    public Vector3D Direction { get; }

    /// <summary>Linear intensity, at least 0.</summary>
    public Intensity Intensity { get; }

    private Formula Own => new(Direction, Intensity);

    /// <inheritdoc/>
    public override bool TrySample(Point3D point, out LightSample sample) => LightFormulas.TrySample(Own, point, out sample);

    [MethodImpl(MethodImplOptions.NoInlining)]
    void IWideLight.Sample<R, F, I>(SurfaceBatch<R, F, I> surfaces, in LightColumns<R, F> samples, int packets) =>
        LightFormulas.Sample(Own, surfaces, samples, packets);

    private readonly record struct Formula(Vector3D Direction, Intensity Intensity) : ILightFormula
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public void Sample<R>(R x, R y, R z, out LightLanes<R> sample)
            where R : unmanaged, IReal<R>
        {
            sample.DirectionX = R.Of(-Direction.X);
            sample.DirectionY = R.Of(-Direction.Y);
            sample.DirectionZ = R.Of(-Direction.Z);
            sample.Distance = R.Of(double.PositiveInfinity);
            sample.Share = R.Of(1);
        }
    }
}
