using System.Runtime.CompilerServices;

namespace LabRaytracer;

/// <summary>Sums and products that keep what rounding would drop.</summary>
/// <remarks>Error-free transformations: Ogita, Rump, Oishi, "Accurate sum and dot product", SIAM J. Sci. Comput. 26(6), 2005.</remarks>
internal static class Compensated
{
    /// <summary>The rounded difference; <paramref name="error"/> is what is missing to the exact one.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static T Difference<T>(T a, T b, out T error)
        where T : unmanaged, IReal<T>
    {
        T difference = a - b;
        T back = difference - a;
        error = (a - (difference - back)) - (b + back);
        return difference;
    }

    /// <summary>The scalar product as if computed with twice the digits, then rounded.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static T Dot<T>(T ax, T ay, T az, T bx, T by, T bz)
        where T : unmanaged, IReal<T>
    {
        T high = Dot(ax, ay, az, bx, by, bz, out T low);
        return high + low;
    }

    /// <summary>The scalar product in two parts.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static T Dot<T>(T ax, T ay, T az, T bx, T by, T bz, out T low)
        where T : unmanaged, IReal<T>
    {
        T x = ax * bx;
        T y = ay * by;
        T z = az * bz;
        T products = T.Fma(ax, bx, -x) + T.Fma(ay, by, -y) + T.Fma(az, bz, -z);
        T xy = Difference(x, -y, out T first);
        T sum = Difference(xy, -z, out T second);
        low = products + (first + second);
        return sum;
    }

    /// <summary>a b - c d without cancellation: the sign is right, the relative error at most 1.5 ulp (Kahan).</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static T DifferenceOfProducts<T>(T a, T b, T c, T d)
        where T : unmanaged, IReal<T>
    {
        T cd = c * d;
        T error = T.Fma(-c, d, cd);
        return T.Fma(a, b, -cd) + error;
    }
}
