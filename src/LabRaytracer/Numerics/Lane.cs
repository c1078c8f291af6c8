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
}
