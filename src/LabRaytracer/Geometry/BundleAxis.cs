using System.Runtime.CompilerServices;

namespace LabRaytracer;

/// <summary>One axis of a bundle of rays: between which numbers all origins and all directions lie.</summary>
internal readonly struct BundleAxis
{
    private readonly double _leastOrigin, _largestOrigin, _leastDirection, _largestDirection;
    private readonly double _inverseOfLeast, _inverseOfLargest;

    /// <param name="leastOrigin">No origin is smaller.</param>
    /// <param name="largestOrigin">No origin is larger.</param>
    /// <param name="leastDirection">No direction is smaller.</param>
    /// <param name="largestDirection">No direction is larger.</param>
    public BundleAxis(double leastOrigin, double largestOrigin, double leastDirection, double largestDirection)
    {
        _leastOrigin = leastOrigin;
        _largestOrigin = largestOrigin;
        _leastDirection = leastDirection;
        _largestDirection = largestDirection;
        _inverseOfLeast = 1 / leastDirection;
        _inverseOfLargest = 1 / largestDirection;
    }

    /// <summary>Tells whether some rays go up the axis and others down, or along none: when they pass a plane across it is then unknown.</summary>
    private bool IsMixed => _leastDirection <= 0 && _largestDirection >= 0;

    /// <summary>Narrows the ray parameters between which any ray of the bundle is inside a slab; nothing on a mixed axis.</summary>
    /// <param name="min">Lower plane.</param>
    /// <param name="max">Upper plane.</param>
    /// <param name="start">No ray is inside before; at least 0.</param>
    /// <param name="end">No ray is inside after; below 0 when none ever is.</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void Narrow(double min, double max, ref double start, ref double end)
    {
        if (IsMixed)
        {
            return;
        }

        bool isUp = _leastDirection > 0;
        double toNear = isUp ? min - _largestOrigin : max - _leastOrigin;
        double toFar = isUp ? max - _leastOrigin : min - _largestOrigin;

        // The fastest ray that starts nearest comes first; the slowest that starts farthest leaves last. The second operand where the first is NaN.
        start = double.MaxNative(toNear * (isUp ? _inverseOfLargest : _inverseOfLeast), start);
        double last = toFar * (isUp ? _inverseOfLeast : _inverseOfLargest);
        end = last >= 0 ? double.MinNative(last, end) : -1;
    }

    /// <summary>Tells whether a ray of a mixed axis may be inside a slab up to a ray parameter; true on other axes.</summary>
    /// <param name="min">Lower plane.</param>
    /// <param name="max">Upper plane.</param>
    /// <param name="end">Largest ray parameter of interest, at least 0.</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public bool Meets(double min, double max, double end) =>
        !IsMixed || !(_leastOrigin + (_leastDirection * end) > max || _largestOrigin + (_largestDirection * end) < min);
}
