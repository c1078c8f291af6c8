using System.Runtime.CompilerServices;

namespace LabRaytracer;

/// <summary>The two ways to run the formula of a lamp: for one point and for a batch. Both give the same bits.</summary>
internal static unsafe class LightFormulas
{
    /// <summary><see cref="Light.TrySample(Point3D, out LightSample)"/> by the formula.</summary>
    public static bool TrySample<TFormula>(TFormula formula, Point3D point, out LightSample sample)
        where TFormula : struct, ILightFormula
    {
        formula.Sample(new Double1(point.X), new Double1(point.Y), new Double1(point.Z), out LightLanes<Double1> s);
        sample = new LightSample(
            new Vector3D(s.DirectionX.Value, s.DirectionY.Value, s.DirectionZ.Value), s.Distance.Value, formula.Intensity * (float)s.Share.Value);
        return s.Share.Value > 0;
    }

    /// <summary><see cref="IWideLight.Sample"/> by the formula.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void Sample<TFormula, R, F, I>(TFormula formula, SurfaceBatch<R, F, I> surfaces, in LightColumns<R, F> samples, int packets)
        where TFormula : struct, ILightFormula
        where R : unmanaged, ILane<R, F, I>
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I>
    {
        // Eight doubles are two registers of which there are few: half as many lanes at a time stay in them.
        if (typeof(R) == typeof(Double8))
        {
            Each<TFormula, Double4, Float4, Int4>(
                formula, (Double4*)surfaces.PointX, (Double4*)surfaces.PointY, (Double4*)surfaces.PointZ,
                Unsafe.As<LightColumns<R, F>, LightColumns<Double4, Float4>>(ref Unsafe.AsRef(in samples)), 2 * packets);
        }
        else
        {
            Each<TFormula, R, F, I>(formula, surfaces.PointX, surfaces.PointY, surfaces.PointZ, samples, packets);
        }
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void Each<TFormula, R, F, I>(TFormula formula, R* x, R* y, R* z, in LightColumns<R, F> samples, int packets)
        where TFormula : struct, ILightFormula
        where R : unmanaged, ILane<R, F, I>
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I>
    {
        LightColumns<R, F> columns = samples;
        F red = F.Of(formula.Intensity.R), green = F.Of(formula.Intensity.G), blue = F.Of(formula.Intensity.B);
        for (int packet = 0; packet < packets; packet++)
        {
            formula.Sample(x[packet], y[packet], z[packet], out LightLanes<R> s);
            columns.DirectionX[packet] = s.DirectionX;
            columns.DirectionY[packet] = s.DirectionY;
            columns.DirectionZ[packet] = s.DirectionZ;
            columns.Distance[packet] = s.Distance;
            F share = R.ToSingle(s.Share);
            columns.Intensity.R[packet] = red * share;
            columns.Intensity.G[packet] = green * share;
            columns.Intensity.B[packet] = blue * share;
        }
    }

    /// <summary>Direction and distance of a lamp at a point; at the lamp itself the direction is +Y and the share 0.</summary>
    /// <returns>Mask of points away from the lamp.</returns>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static R Towards<R>(Point3D position, R x, R y, R z, out LightLanes<R> sample)
        where R : unmanaged, IReal<R> => Towards(R.Of(position.X) - x, R.Of(position.Y) - y, R.Of(position.Z) - z, out sample);

    /// <summary>Direction and distance of a lamp by the vector to it; without a length the direction is +Y and the share 0.</summary>
    /// <returns>Mask of points away from the lamp.</returns>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static R Towards<R>(R toX, R toY, R toZ, out LightLanes<R> sample)
        where R : unmanaged, IReal<R>
    {
        sample.Distance = R.Sqrt(Lane.Dot(toX, toY, toZ, toX, toY, toZ));
        R away = R.Less(R.Zero, sample.Distance);
        sample.DirectionX = R.Select(away, toX / sample.Distance, R.Zero);
        sample.DirectionY = R.Select(away, toY / sample.Distance, R.Of(1));
        sample.DirectionZ = R.Select(away, toZ / sample.Distance, R.Zero);
        sample.Share = away & R.Of(1);
        return away;
    }

    /// <summary>How light fades at distances, as <see cref="Attenuation.At"/> does.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static R Fade<R>(Attenuation attenuation, R distance)
        where R : unmanaged, IReal<R> =>
        R.Of(1) / R.Fma(R.Fma(R.Of(attenuation.Quadratic), distance, R.Of(attenuation.Linear)), distance, R.Of(attenuation.Constant));
}
