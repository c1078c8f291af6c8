using System.Runtime.CompilerServices;

namespace LabRaytracer;

/// <summary>A smooth random function of space (Polish: szum): one or several octaves of lattice noise.</summary>
/// <remarks>
/// <para>n(p) = (sum of gain^i b_i(lacunarity^i p)) / (sum of gain^i) over the octaves i = 0, 1, ..., with b_i the lattice noise of <see cref="Kind"/> or its
/// absolute value: dividing by the weights keeps the range of one octave however many there are. Lattice points are the points with whole coordinates.</para>
/// <para>Every octave has random numbers of its own, made from <see cref="Seed"/> by integer arithmetic: the same on every machine. The pattern is as fine at 1e6 as
/// near 0 and does not mirror at 0; it repeats after 2^24 cells, simplex noise after 3 x 2^24.</para>
/// <para>Immutable, thread safe.</para>
/// </remarks>
public sealed class Noise
{
    private readonly double _lacunarity = 2;
    private readonly double _gain = 0.5;
    private readonly int _octaves = 1;

    /// <summary>The lattice noise. Default: gradient.</summary>
    public NoiseKind Kind { get; init => field = PropertyChecks.Known(value); }

    /// <summary>Whether octaves count as they are or by their absolute values. Default: as they are.</summary>
    public NoiseSum Sum { get; init => field = PropertyChecks.Known(value); }

    /// <summary>Number of octaves, [1, 16]. Default: 1.</summary>
    /// <exception cref="ArgumentOutOfRangeException">Outside [1, 16].</exception>
    public int Octaves
    {
        get => _octaves;
        init => _octaves = value is >= 1 and <= 16
            ? value
            : throw new ArgumentOutOfRangeException(nameof(value), value, "The number of octaves must be in [1, 16].");
    }

    /// <summary>Frequency of an octave relative to the one before, [1, 16]. Default: 2.</summary>
    /// <exception cref="ArgumentOutOfRangeException">Outside [1, 16] or NaN.</exception>
    public double Lacunarity
    {
        get => _lacunarity;
        init => _lacunarity = value is >= 1 and <= 16
            ? value
            : throw new ArgumentOutOfRangeException(nameof(value), value, "The lacunarity of a noise must be in [1, 16].");
    }

    /// <summary>Weight of an octave relative to the one before, [0, 1]. Default: 0.5.</summary>
    /// <exception cref="ArgumentOutOfRangeException">Outside [0, 1] or NaN.</exception>
    public double Gain
    {
        get => _gain;
        init => _gain = value is >= 0 and <= 1
            ? value
            : throw new ArgumentOutOfRangeException(nameof(value), value, "The gain of a noise must be in [0, 1].");
    }

    /// <summary>Chooses one of many patterns; any number. Default: 0.</summary>
    public int Seed { get; init; }

    /// <summary>Largest absolute value: 1.0364 for gradient noise, 1 for the others.</summary>
    public double Bound => Kind == NoiseKind.Gradient ? 1.0364 : 1;

    /// <summary>The noise at a point, [-<see cref="Bound"/>, <see cref="Bound"/>]; turbulence is not below 0.</summary>
    /// <param name="point">The point, in cells; finite.</param>
    public float At(Point3D point) => At<Double1, Float1, Int1>(new(point.X), new(point.Y), new(point.Z), Float1.Zero, isFlat: false).Value;

    /// <summary>The noise at many points.</summary>
    /// <param name="x">Coordinate in cells.</param>
    /// <param name="y">Coordinate in cells.</param>
    /// <param name="z">Coordinate in cells.</param>
    /// <param name="width">Width of the filter in cells of the first octave; 0 for none.</param>
    /// <param name="isFlat">True if z is 0 everywhere.</param>
    [MethodImpl(MethodImplOptions.NoInlining)]
    internal F At<R, F, I>(R x, R y, R z, F width, bool isFlat)
        where R : unmanaged, ILane<R, F, I>
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I>
    {
        F sum = F.Zero;
        double frequency = 1, weight = 1, weights = 0;
        for (int octave = 0; octave < Octaves; octave++)
        {
            F kept = FilterFade.Kept(width * F.Of(frequency));
            F number = F.Of(Mean(isFlat));
            if (F.Any(F.Less(F.Zero, kept)))
            {
                R scale = R.Of(frequency);
                F here = Layer<R, F, I>(x * scale, y * scale, z * scale, CellHash.Key(Seed, octave), isFlat);
                here = Sum == NoiseSum.Turbulence ? F.Abs(here) : here;
                number = FilterFade.Mix(number, here, kept);
            }

            sum = F.Fma(F.Of(weight), number, sum);
            weights += weight;
            weight *= Gain;
            frequency *= Lacunarity;
        }

        return sum * F.Of(1 / weights);
    }

    /// <summary>The mean of one octave: 0, or that of the absolute values, measured on at least 60000 points.</summary>
    private double Mean(bool isFlat) => (Sum, Kind, isFlat) switch
    {
        (NoiseSum.Fbm, _, _) => 0,
        (_, NoiseKind.Gradient, false) => 0.2201,
        (_, NoiseKind.Gradient, true) => 0.2046,
        (_, NoiseKind.Value, false) => 0.2556,
        (_, NoiseKind.Value, true) => 0.3190,
        (_, NoiseKind.Simplex, false) => 0.3140,
        (_, NoiseKind.Simplex, true) => 0.3144,
        (_, _, false) => 0.3508,
        _ => 0.3915,
    };

    private F Layer<R, F, I>(R x, R y, R z, int key, bool isFlat)
        where R : unmanaged, ILane<R, F, I>
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I> => Kind switch
        {
            NoiseKind.Gradient => GradientNoise.At<R, F, I>(x, y, z, key, isFlat),
            NoiseKind.Value => ValueNoise.Linear<R, F, I>(x, y, z, key, isFlat),
            NoiseKind.Simplex => SimplexNoise.At<R, F, I>(x, y, z, key),
            _ => ValueNoise.Cubic<R, F, I>(x, y, z, key, isFlat),
        };
}
