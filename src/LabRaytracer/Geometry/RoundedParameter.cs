using System.Runtime.CompilerServices;

namespace LabRaytracer;

/// <summary>Rounding tests of ray parameters that are known with twice the digits and a bound of their error.</summary>
/// <remarks>Ziv, "Fast evaluation of elementary mathematical functions with correctly rounded last bit", ACM TOMS 17(3), 1991.</remarks>
internal static class RoundedParameter
{
    /// <summary>Between these bounds no squared length that takes part loses digits by underflow or overflow.</summary>
    private const double Least = 1e-120, Most = 1e120;

    /// <summary>The unit of error bounds: 128 times the square of the precision.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static R Unit<R>()
        where R : unmanaged, IReal<R> => R.Of(R.IsSingle ? 128.0 / (1L << 48) : 128 * 1.232595164407831e-32);

    /// <summary>Mask: the high part is the number's nearest neighbour, wherever in the bound of its error the number lies.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static R IsCertain<R>(in DoubleWord<R> number, R error)
        where R : unmanaged, IReal<R> =>
        R.Equal(number.High + (number.Low - error), number.High) & R.Equal(number.High + (number.Low + error), number.High);

    /// <summary>Mask: a squared length is neither too small nor too large for error bounds to hold.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static R IsOrdinary<R>(R squaredLength)
        where R : unmanaged, IReal<R> => R.LessOrEqual(R.Of(Least), squaredLength) & R.LessOrEqual(squaredLength, R.Of(Most));

    /// <summary>One ray of a group of lanes.</summary>
    public static Ray Lane<R>(in RayLanes<R> ray, int lane)
        where R : unmanaged, IReal<R> => new(
            new Point3D(R.Get(ray.OriginX, lane), R.Get(ray.OriginY, lane), R.Get(ray.OriginZ, lane)),
            new Vector3D(R.Get(ray.DirectionX, lane), R.Get(ray.DirectionY, lane), R.Get(ray.DirectionZ, lane)));

    /// <summary>Lanes with one of them replaced, unless by NaN.</summary>
    public static R Replace<R>(R lanes, int lane, double value)
        where R : unmanaged, IReal<R> => double.IsNaN(value) ? lanes : R.Select(R.Equal(R.Iota(0), R.Of(lane)), R.Of(value), lanes);
}
