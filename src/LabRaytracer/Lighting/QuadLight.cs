using System.Runtime.CompilerServices;

namespace LabRaytracer;

/// <summary>A flat lamp (Polish: światło powierzchniowe): a parallelogram that shines evenly and makes soft shadows.</summary>
/// <remarks>
/// <para>Immutable, thread safe. Every point of the lamp has the same radiance L in all directions of a side that shines. With area A, distance d, and e the angle
/// between the lamp's normal and the direction to the lit point, one sample stands for a point light of intensity L A cos(e) / (pi d^2): the intensity of a
/// lamp is the irradiance at perpendicular incidence divided by pi, so that a matte surface that sees nothing but the lamp has the brightness k_d L.
/// From far away the lamp is a <see cref="PointLight"/> of intensity L A cos(e) / pi with <see cref="Attenuation"/> (0, 0, 1).</para>
/// <para>Samples fill the lamp evenly: 2^m samples have one in each cell of every grid of 2^a x 2^(m - a) cells. Each pixel, and each sample of a pixel, has its own.
/// One sample lies in the middle of the lamp and makes hard shadows without noise.</para>
/// </remarks>
public sealed class QuadLight : Light, IWideAreaLight
{
    /// <summary>Most samples of a lamp at each point.</summary>
    public const int MaxSamples = 4096;

    private readonly double _area;

    /// <summary>Creates a flat lamp.</summary>
    /// <param name="corner">A corner, world space; finite.</param>
    /// <param name="edgeV">Edge from the corner, scene units; finite, not 0.</param>
    /// <param name="edgeU">Other edge from the corner, scene units; finite, not parallel to the first. The normal is the direction of edgeU x edgeV, as of a <see cref="Quad"/>.</param>
    /// <param name="radiance">Linear radiance, what a camera sees of the lamp; finite, not negative.</param>
    /// <exception cref="ArgumentException">A number is not finite, the edges span no area, or the radiance is negative.</exception>
    public QuadLight(Point3D corner, Vector3D edgeV, Vector3D edgeU, Intensity radiance)
    {
        Quad = new Quad(corner, edgeV, edgeU);
        Radiance = LightChecks.Intensity(radiance);
        _area = Vector3D.Cross(edgeU, edgeV).Length;
    }

    /// <summary>The parallelogram, world space.</summary>
    public Quad Quad { get; }

    /// <summary>Linear radiance, at least 0.</summary>
    public Intensity Radiance { get; }

    /// <summary>Samples at each point, [1, 4096]; powers of two fill the lamp best. Default: 16. Their noise falls with the number, their time grows with it.</summary>
    /// <exception cref="ArgumentOutOfRangeException">Outside [1, 4096].</exception>
    public int Samples { get; init => field = LightChecks.Samples(value); } = 16;

    /// <summary>Sides that shine. Default: the side of the normal.</summary>
    public LightSides Sides { get; init => field = PropertyChecks.Known(value); }

    /// <summary>Tells whether rays see the lamp: from the camera, in mirrors, through glass. It never casts a shadow itself. Default: no.</summary>
    public bool IsVisible { get; init; }

    /// <inheritdoc/>
    public override int SampleCount => Samples;

    private Formula Whole => new(this, 1);

    /// <summary>The light that arrives from the middle of the lamp, as if all its light came from there.</summary>
    public override bool TrySample(Point3D point, out LightSample sample) => TrySample(point, SquarePoint.Center, out sample);

    /// <inheritdoc/>
    public override bool TrySample(Point3D point, SquarePoint place, out LightSample sample)
    {
        Whole.Sample(
            new Double1(point.X), new Double1(point.Y), new Double1(point.Z), new Double1(place.S), new Double1(place.T), out LightLanes<Double1> s);
        sample = new LightSample(
            new Vector3D(s.DirectionX.Value, s.DirectionY.Value, s.DirectionZ.Value), s.Distance.Value, Radiance * (float)s.Share.Value);
        return s.Share.Value > 0;
    }

    [MethodImpl(MethodImplOptions.NoInlining)]
    unsafe void IWideAreaLight.Sample<R, F, I>(SurfaceBatch<R, F, I> surfaces, in SquareColumns<R> places, in LightColumns<R, F> samples, int packets)
    {
        Formula formula = new(this, 1.0 / Samples);
        SquareColumns<R> at = places;
        LightColumns<R, F> columns = samples;
        R middle = R.Of(0.5);
        F red = F.Of(Radiance.R), green = F.Of(Radiance.G), blue = F.Of(Radiance.B);
        for (int packet = 0; packet < packets; packet++)
        {
            (R s, R t) = Samples == 1 ? (middle, middle) : (at.S[packet], at.T[packet]);
            formula.Sample(surfaces.PointX[packet], surfaces.PointY[packet], surfaces.PointZ[packet], s, t, out LightLanes<R> sample);
            columns.DirectionX[packet] = sample.DirectionX;
            columns.DirectionY[packet] = sample.DirectionY;
            columns.DirectionZ[packet] = sample.DirectionZ;
            columns.Distance[packet] = sample.Distance;
            F share = R.ToSingle(sample.Share);
            columns.Intensity.R[packet] = red * share;
            columns.Intensity.G[packet] = green * share;
            columns.Intensity.B[packet] = blue * share;
        }
    }

    /// <param name="Light">The lamp.</param>
    /// <param name="Part">Part of the whole light that one sample stands for.</param>
    private readonly record struct Formula(QuadLight Light, double Part)
    {
        /// <summary>Largest share: only points closer than 1e-10 of the lamp's size have more, and products with it stay finite.</summary>
        private const double MostShare = 1e20;

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public void Sample<R>(R x, R y, R z, R s, R t, out LightLanes<R> sample)
            where R : unmanaged, IReal<R>
        {
            Point3D corner = Light.Quad.Corner;
            Vector3D u = Light.Quad.EdgeU, v = Light.Quad.EdgeV, n = Light.Quad.Normal;
            R toX = R.Fma(s, R.Of(u.X), R.Fma(t, R.Of(v.X), R.Of(corner.X))) - x;
            R toY = R.Fma(s, R.Of(u.Y), R.Fma(t, R.Of(v.Y), R.Of(corner.Y))) - y;
            R toZ = R.Fma(s, R.Of(u.Z), R.Fma(t, R.Of(v.Z), R.Of(corner.Z))) - z;
            R away = LightFormulas.Towards(toX, toY, toZ, out sample);
            R cosine = -Lane.Dot(sample.DirectionX, sample.DirectionY, sample.DirectionZ, R.Of(n.X), R.Of(n.Y), R.Of(n.Z));
            cosine = Light.Sides == LightSides.Both ? R.Abs(cosine) : R.Max(cosine, R.Zero);
            R perArea = cosine / (sample.Distance * sample.Distance);
            sample.Share = away & R.Min(perArea * R.Of(Light._area * Part / Math.PI), R.Of(MostShare));
        }
    }
}
