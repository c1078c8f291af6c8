using System.Numerics;
using System.Runtime.CompilerServices;

namespace LabRaytracer;

/// <summary>Sums over the slopes of a pencil, for the shear that makes it upright: the slope of the straight line of least squares.</summary>
/// <typeparam name="R">Lane type of geometry.</typeparam>
internal struct SlopeSums<R>
    where R : unmanaged, IReal<R>
{
    private R _firstX, _firstY;
    private R _count, _x, _y, _xx, _xy;
    private bool _isStarted;

    /// <summary>The shear, within <see cref="RayPencil.LargestShear"/> on either side; 0 where all slopes are the same.</summary>
    public readonly double Shear
    {
        get
        {
            double count = Total(_count), x = Total(_x);
            double variance = (count * Total(_xx)) - (x * x), shear = ((count * Total(_xy)) - (x * Total(_y))) / variance;
            return variance > 0 ? Math.Clamp(shear, -RayPencil.LargestShear, RayPencil.LargestShear) : 0;
        }
    }

    /// <summary>Adds the slopes of the rays that are on.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void Add(R x, R y, R isOn)
    {
        uint on = R.Bits(isOn);
        if (!_isStarted && on != 0)
        {
            // Differences from one of them keep their digits.
            int first = BitOperations.TrailingZeroCount(on);
            (_firstX, _firstY, _isStarted) = (R.Of(R.Get(x, first)), R.Of(R.Get(y, first)), true);
        }

        x = (x - _firstX) & isOn;
        y = (y - _firstY) & isOn;
        _count += R.Of(1) & isOn;
        _x += x;
        _y += y;
        _xx = R.Fma(x, x, _xx);
        _xy = R.Fma(x, y, _xy);
    }

    private static unsafe double Total(R lanes)
    {
        double total = 0;
        for (int lane = 0; lane < R.Width; lane++)
        {
            total += Lane.Take(&lanes, lane);
        }

        return total;
    }
}
