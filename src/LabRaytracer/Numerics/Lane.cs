using System.Runtime.CompilerServices;

namespace LabRaytracer;

/// <summary>Small formulas of vectors in lanes.</summary>
internal static class Lane
{
    /// <summary>Scalar product.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static T Dot<T>(T ax, T ay, T az, T bx, T by, T bz)
        where T : unmanaged, IReal<T> => T.Fma(ax, bx, T.Fma(ay, by, az * bz));

    /// <summary>
    /// Bound of the error of a point whose largest intermediate was <paramref name="size"/>: 32 units of the lane's precision.
    /// A few roundings make a hit point; the rest is margin, so that a ray that starts this far outside cannot meet its own surface again.
    /// </summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static T Slack<T>(T size)
        where T : unmanaged, IReal<T> => size * T.Of(T.IsSingle ? 1.9073486328125e-6 : 3.552713678800501e-15);

    /// <summary>The least of the lanes, none of which is NaN.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static double Least<T>(T lanes)
        where T : unmanaged, IReal<T> => -T.Largest(-lanes);

    /// <summary>Reads one element of a column of lanes, exactly.</summary>
    /// <param name="column">The column.</param>
    /// <param name="element">Number of the scalar.</param>
    public static unsafe double Take<T>(T* column, int element)
        where T : unmanaged, IReal<T> => T.IsSingle ? ((float*)column)[element] : ((double*)column)[element];

    /// <summary>Writes one element of a column of lanes, rounded to its precision.</summary>
    /// <param name="column">The column.</param>
    /// <param name="element">Number of the scalar.</param>
    /// <param name="value">The number.</param>
    public static unsafe void Put<T>(T* column, int element, double value)
        where T : unmanaged, IReal<T>
    {
        if (T.IsSingle)
        {
            ((float*)column)[element] = (float)value;
        }
        else
        {
            ((double*)column)[element] = value;
        }
    }
}
