using System.Runtime.CompilerServices;

namespace LabRaytracer;

/// <summary>Colours along a line: at stops as given, in between interpolated in linear light, beyond the ends constant.</summary>
/// <remarks>
/// <para>color(t) = lerp(c_i, c_i+1, (t - p_i) / (p_i+1 - p_i)) for p_i &lt;= t &lt; p_i+1. Two stops at one place make a step: from there on the later one holds.</para>
/// <para>Immutable, thread safe.</para>
/// </remarks>
public sealed class ColorRamp
{
    private readonly ColorStop[] _stops;

    /// <summary>A ramp of one or more stops, in any order; those at the same place keep their order.</summary>
    /// <param name="stops">The stops.</param>
    /// <exception cref="ArgumentException">There are none, or a position is not finite.</exception>
    public ColorRamp(params IEnumerable<ColorStop> stops)
    {
        ArgumentNullException.ThrowIfNull(stops);
        _stops = [.. stops.OrderBy(stop => stop.Position)];
        if (_stops.Length == 0 || !_stops.All(stop => double.IsFinite(stop.Position)))
        {
            throw new ArgumentException("A colour ramp needs at least one stop, each at a finite position.", nameof(stops));
        }

        Mean = FindMean();
    }

    /// <summary>Black at 0, white at 1.</summary>
    public static ColorRamp Grey { get; } = Between(Intensity.Black, Intensity.White);

    /// <summary>The stops by position.</summary>
    public IReadOnlyList<ColorStop> Stops => _stops;

    /// <summary>The mean of the colours from 0 to 1: what is left of a pattern that covers them evenly when it is too fine to be seen.</summary>
    public Intensity Mean { get; }

    /// <summary>One colour at 0, another at 1.</summary>
    /// <param name="first">Colour at 0 and below, linear.</param>
    /// <param name="last">Colour at 1 and above, linear.</param>
    public static ColorRamp Between(Intensity first, Intensity last) => new(new ColorStop(0, first), new ColorStop(1, last));

    /// <summary>The colour at a place.</summary>
    /// <param name="position">The place.</param>
    public Intensity At(float position)
    {
        At(new Float1(position), out Float1 red, out Float1 green, out Float1 blue);
        return new Intensity(red.Value, green.Value, blue.Value);
    }

    /// <summary>The colours at many places.</summary>
    [MethodImpl(MethodImplOptions.NoInlining)]
    internal void At<F>(F position, out F red, out F green, out F blue)
        where F : unmanaged, IReal<F>
    {
        Intensity color = _stops[0].Color;
        (red, green, blue) = (F.Of(color.R), F.Of(color.G), F.Of(color.B));
        for (int i = 0; i < _stops.Length; i++)
        {
            ColorStop stop = _stops[i];
            F isBehind = F.LessOrEqual(F.Of(stop.Position), position);
            Intensity step = default;
            F share = F.Zero;
            if (i + 1 < _stops.Length && _stops[i + 1].Position > stop.Position)
            {
                step = _stops[i + 1].Color - stop.Color;
                share = (position - F.Of(stop.Position)) * F.Of(1 / (_stops[i + 1].Position - stop.Position));
            }

            red = F.Select(isBehind, F.Fma(share, F.Of(step.R), F.Of(stop.Color.R)), red);
            green = F.Select(isBehind, F.Fma(share, F.Of(step.G), F.Of(stop.Color.G)), green);
            blue = F.Select(isBehind, F.Fma(share, F.Of(step.B), F.Of(stop.Color.B)), blue);
        }
    }

    /// <summary>The trapezoids between 0, the stops in between, and 1.</summary>
    private Intensity FindMean()
    {
        double[] places = [0, .. _stops.Select(stop => stop.Position).Where(position => position is > 0 and < 1).Distinct(), 1];
        Intensity sum = Intensity.Black;
        for (int i = 0; i + 1 < places.Length; i++)
        {
            // The middle of a part has its mean, because the ramp is linear there.
            sum += At((float)((places[i] + places[i + 1]) / 2)) * (float)(places[i + 1] - places[i]);
        }

        return sum;
    }
}
