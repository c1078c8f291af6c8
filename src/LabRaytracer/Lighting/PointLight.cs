using System.Runtime.CompilerServices;

namespace LabRaytracer;

/// <summary>A lamp at a point that shines in all directions (Polish: światło punktowe).</summary>
/// <remarks>Immutable, thread safe.</remarks>
public sealed class PointLight : Light, IWideLight
{
    /// <summary>Creates a point light.</summary>
    /// <param name="position">Position, world space; finite.</param>
    /// <param name="intensity">Linear intensity at distance 0 of no fading; finite, not negative.</param>
    /// <exception cref="ArgumentOutOfRangeException">The position is not finite, or the intensity negative or not finite.</exception>
    public PointLight(Point3D position, Intensity intensity)
    {
        Position = LightChecks.Position(position);
        Intensity = LightChecks.Intensity(intensity);
    }

    /// <summary>Position, world space.</summary>
    public Point3D Position { get; }

    /// <summary>Linear intensity, at least 0.</summary>
    public Intensity Intensity { get; }

    /// <summary>How the light fades with distance. Default: not at all.</summary>
    public Attenuation Attenuation { get; init => field = PropertyChecks.NotNull(value); } = Attenuation.None;

    /// <summary>The lamp's formula.</summary>
    internal Formula Own => new(Position, Intensity, Attenuation, !Attenuation.IsNone);

    /// <inheritdoc/>
    public override bool TrySample(Point3D point, out LightSample sample) => LightFormulas.TrySample(Own, point, out sample);

    void IWideLight.Sample<R, F, I>(SurfaceBatch<R, F, I> surfaces, in LightColumns<R, F> samples, int packets) => Shine(surfaces, samples, packets);

    /// <summary>The same, not virtual: ahead-of-time compilers do not see through virtual generic methods.</summary>
    [MethodImpl(MethodImplOptions.NoInlining)]
    internal void Shine<R, F, I>(SurfaceBatch<R, F, I> surfaces, in LightColumns<R, F> samples, int packets)
        where R : unmanaged, ILane<R, F, I>
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I> =>
        LightFormulas.Sample(Own, surfaces, samples, packets);

    /// <summary>Direction, distance and share of the light at points.</summary>
    internal readonly record struct Formula(Point3D Position, Intensity Intensity, Attenuation Attenuation, bool Fades) : ILightFormula
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public void Sample<R>(R x, R y, R z, out LightLanes<R> sample)
            where R : unmanaged, IReal<R>
        {
            R away = LightFormulas.Towards(Position, x, y, z, out sample);
            if (Fades)
            {
                sample.Share = away & LightFormulas.Fade(Attenuation, sample.Distance);
            }
        }

        /// <summary>Light at points by the vectors from them to the lamp.</summary>
        /// <param name="x">To the lamp.</param>
        /// <param name="y">To the lamp.</param>
        /// <param name="z">To the lamp.</param>
        /// <param name="distance">Their lengths.</param>
        /// <returns>Shares of the intensity that arrive.</returns>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public R Share<R>(R x, R y, R z, out R distance)
            where R : unmanaged, IReal<R>
        {
            distance = R.Sqrt(Lane.Dot(x, y, z, x, y, z));
            return Fades ? LightFormulas.Fade(Attenuation, distance) : R.Of(1);
        }
    }
}
