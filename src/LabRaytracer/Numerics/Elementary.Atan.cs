using System.Runtime.CompilerServices;

namespace LabRaytracer;

/// <content>Angles of points, in turns.</content>
internal static partial class Elementary
{
    /// <summary>Azimuth of the point (x, y) of a plane: turns from the x axis towards the y axis, [0, 1); 0 at the origin.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static T Atan2Turns<T>(T y, T x)
        where T : unmanaged, IReal<T> => SphereTurns(y, T.Zero, x).Azimuth;

    /// <summary>
    /// Azimuth around +Y from +Z towards +X, turns, [0, 1), 0 on the axis; and the half turns from the south pole to the point, [0, 1]:
    /// 0 at the south pole, 1/2 on the equator and at the origin, 1 at the north pole.
    /// </summary>
    /// <remarks>
    /// Any input has a result in these ranges: a NaN coordinate counts as 0, an infinite one as the largest finite number.
    /// The length of (x, y, z) does not matter; polar form, so that nothing cancels near the poles.
    /// </remarks>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static (T Azimuth, T Height) SphereTurns<T>(T x, T y, T z)
        where T : unmanaged, IReal<T>
    {
        T ax = T.Abs(x);
        T ay = T.Abs(y);
        T az = T.Abs(z);
        T sum = ax + az;
        T ordinary = T.LessOrEqual(Power<T>(-39, -199), sum)
            & T.Less(sum + ay, Power<T>(60, 400));
        if (!T.All(ordinary))
        {
            return SphereTurnsRescaled(x, y, z);
        }

        T larger = T.Max(ax, az);
        T smaller = T.Min(ax, az);
        return (Azimuth(x, z, smaller, larger), Height(y, ay, Radius(smaller, larger)));
    }

    /// <summary>Turns from +z towards +x, given the smaller and the larger of |x| and |z| (or both times a power of two).</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static T Azimuth<T>(T x, T z, T smaller, T larger)
        where T : unmanaged, IReal<T>
    {
        T nearX = T.Less(T.Abs(z), T.Abs(x));
        T behind = T.Less(z, T.Zero);
        T left = T.Less(x, T.Zero);
        T start = T.Select(nearX, T.Of(0.25), behind & T.Of(0.5));
        start = T.Select(left, T.Of(1) - start, start);
        T turns = AddAtanTurns(start, nearX ^ behind ^ left, smaller, larger);
        return T.Min(turns, BelowOne<T>());
    }

    /// <summary>Half turns from the south pole, given |y| and the distance from the axis (or both times a power of two).</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static T Height<T>(T y, T height, T radius)
        where T : unmanaged, IReal<T>
    {
        T low = T.LessOrEqual(height, radius);
        T north = T.Less(T.Zero, y);
        T start = T.Select(low, T.Of(0.25), north & T.Of(0.5));
        T turns = AddAtanTurns(start, north ^ low, T.Min(height, radius), T.Max(height, radius));
        return turns + turns;
    }

    /// <summary>sqrt(smaller² + larger²); the caller keeps both squares in range.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static T Radius<T>(T smaller, T larger)
        where T : unmanaged, IReal<T> => T.Sqrt(T.Fma(larger, larger, smaller * smaller));

    /// <summary>start + atan(smaller / larger) / 2 pi, or minus where the mask says so; 0 &lt;= smaller &lt;= larger, larger above 0.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static T AddAtanTurns<T>(T start, T minus, T smaller, T larger)
        where T : unmanaged, IReal<T>
    {
        // Above pi/8: atan(q) = pi/4 + atan((q - 1) / (q + 1)).
        T steep = T.Less(larger * T.Of(0.41421356237309503), smaller);
        T q = T.Select(steep, smaller - larger, smaller) / T.Select(steep, smaller + larger, larger);
        T s = q * q;
        T series = T.Fma(s, T.IsSingle ? AtanTailSingle(s) : AtanTailDouble(s), T.Of(1 / Math.Tau));
        T turns = T.Fma(q, series, steep & T.Of(0.125));
        return start + (turns ^ (minus & T.Of(-0.0)));
    }

    /// <summary>Distance of (x, z) from the origin, without overflow or underflow on the way.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static T Hypotenuse<T>(T x, T z)
        where T : unmanaged, IReal<T>
    {
        T ax = T.Abs(x);
        T az = T.Abs(z);
        T larger = T.Max(ax, az);
        T huge = T.Less(Power<T>(60, 400), larger);
        T tiny = T.Less(larger, Power<T>(-40, -300));
        T one = T.Of(1);
        T scale = T.Select(huge, Power<T>(-100, -600), T.Select(tiny, Power<T>(100, 600), one));
        T back = T.Select(huge, Power<T>(100, 600), T.Select(tiny, Power<T>(-100, -600), one));
        return Radius(T.Min(ax, az) * scale, larger * scale) * back;
    }

    /// <summary>The same for any input: lanes out of the ordinary are scaled by powers of two first.</summary>
    [MethodImpl(MethodImplOptions.NoInlining)]
    private static (T Azimuth, T Height) SphereTurnsRescaled<T>(T x, T y, T z)
        where T : unmanaged, IReal<T>
    {
        T ax = AnyMagnitude(x);
        T ay = AnyMagnitude(y);
        T az = AnyMagnitude(z);
        T larger = T.Max(ax, az);
        T smaller = T.Min(ax, az);
        T onAxis = T.Equal(larger, T.Zero);
        T scale = AzimuthScale(larger);
        T azimuth = Azimuth(x, z, smaller * scale, T.Select(onAxis, T.Of(1), larger * scale));

        T origin = onAxis & T.Equal(ay, T.Zero);
        RadiusScales(larger, ay, out T squares, out T radiusScale, out T heightScale, out T undo);
        T radius = Radius(smaller * squares, larger * squares) * radiusScale;
        T height = Height(y, ay * heightScale, T.Select(origin, T.Of(1), radius));
        return (azimuth, T.Select(T.Less(y, T.Zero), height * undo, height));
    }
}
