namespace LabRaytracer;

/// <summary>Spreads evenly distributed numbers as a pixel filter weighs the picture.</summary>
/// <remarks>
/// Where a filter is negative, samples lie as densely as its absolute value asks, and count negatively. Table and warp use + - * / and square roots
/// alone: the same bits on every machine.
/// </remarks>
internal sealed class PixelWarp
{
    // Mitchell and Netravali 1988 with B = C = 1/3: (7 t^3 - 12 t^2 + 16/3) / 6 below 1, -7/18 (t - 2)^2 (t - 8/7) from 1 to 2.
    private const double Root = 8.0 / 7, Radius = 2;
    private const int Steps = 1024;

    private readonly PixelFilter _filter;
    private readonly double[]? _inverse;

    public PixelWarp(PixelFilter filter)
    {
        _filter = filter;
        if (filter == PixelFilter.Mitchell)
        {
            double gain = AbsoluteArea(Radius) / Area(Radius);
            Gain = gain * gain;
            _inverse = Invert();
        }
    }

    /// <summary>Whether samples may count negatively.</summary>
    public bool IsSigned => _inverse is not null;

    /// <summary>Whether samples stay where they are.</summary>
    public bool IsNone => _filter == PixelFilter.Box;

    /// <summary>Integral of the filter's absolute value over its integral, both axes: 1 for filters that are nowhere negative.</summary>
    public double Gain { get; } = 1;

    /// <summary>How many pixels to each side of a pixel the filter reaches.</summary>
    public int Reach => _filter switch
    {
        PixelFilter.Box => 0,
        PixelFilter.Tent => 1,
        _ => 2,
    };

    /// <summary>Place of a sample along one axis, pixels from the pixel's left or top edge.</summary>
    /// <param name="even">Evenly distributed, [0, 1).</param>
    public double Place(double even)
    {
        if (IsNone)
        {
            return even;
        }

        double side = (2 * even) - 1, part = Math.Abs(side);
        double distance = _inverse is { } inverse ? Interpolate(inverse, part) : 1 - Math.Sqrt(1 - part);
        return 0.5 + (side < 0 ? -distance : distance);
    }

    /// <summary>Tells whether a sample counts negatively, from its place along both axes.</summary>
    public bool IsNegative(double x, double y) => IsSigned && (Math.Abs(x - 0.5) > Root) != (Math.Abs(y - 0.5) > Root);

    /// <summary>Integral of the filter from 0.</summary>
    private static double Area(double t) => t <= 1
        ? ((((((7.0 / 4 * t) - 4) * t * t) + (16.0 / 3)) * t) / 6)
        : Area(1) + Primitive(t) - Primitive(1);

    private static double Primitive(double t) => ((((((((-7.0 / 12 * t) + 4) * t) - 10) * t) + (32.0 / 3)) * t) / 6);

    /// <summary>Integral of the filter's absolute value from 0.</summary>
    private static double AbsoluteArea(double t) => t <= Root ? Area(t) : (2 * Area(Root)) - Area(t);

    /// <summary>Distances from the centre within which lie 0, 1/n, 2/n, ... 1 of the absolute area.</summary>
    private static double[] Invert()
    {
        double[] inverse = new double[Steps + 1];
        inverse[Steps] = Radius;
        for (int step = 1; step < Steps; step++)
        {
            double low = 0, high = Radius, wanted = AbsoluteArea(Radius) * step / Steps;
            for (int half = 0; half < 60; half++)
            {
                double middle = (low + high) / 2;
                (low, high) = AbsoluteArea(middle) < wanted ? (middle, high) : (low, middle);
            }

            inverse[step] = low;
        }

        return inverse;
    }

    private static double Interpolate(double[] inverse, double part)
    {
        double place = part * Steps;
        int step = Math.Min((int)place, Steps - 1);
        return inverse[step] + ((place - step) * (inverse[step + 1] - inverse[step]));
    }
}
