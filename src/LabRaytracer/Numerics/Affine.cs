using System.Runtime.CompilerServices;

namespace LabRaytracer;

/// <summary>Affine maps of points, vectors and normals in lanes, by the rows of a <see cref="Transform"/>; the bits of its own calls.</summary>
internal static class Affine
{
    /// <summary>A point.</summary>
    /// <param name="rows">12 numbers, row after row.</param>
    /// <param name="x">Coordinate; replaced.</param>
    /// <param name="y">Coordinate; replaced.</param>
    /// <param name="z">Coordinate; replaced.</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void Point<T>(ReadOnlySpan<double> rows, ref T x, ref T y, ref T z)
        where T : unmanaged, IReal<T>
    {
        Step(rows, ref x, ref y, ref z);
        x += T.Of(rows[3]);
        y += T.Of(rows[7]);
        z += T.Of(rows[11]);
    }

    /// <summary>A vector.</summary>
    /// <param name="rows">12 numbers, row after row.</param>
    /// <param name="x">Component; replaced.</param>
    /// <param name="y">Component; replaced.</param>
    /// <param name="z">Component; replaced.</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void Step<T>(ReadOnlySpan<double> rows, ref T x, ref T y, ref T z)
        where T : unmanaged, IReal<T> =>
        (x, y, z) = (Row(rows, 0, 1, x, y, z), Row(rows, 4, 1, x, y, z), Row(rows, 8, 1, x, y, z));

    /// <summary>A unit normal: the product with the transpose of the inverse map, made length 1.</summary>
    /// <param name="inverseRows">12 numbers of the inverse map, row after row.</param>
    /// <param name="x">Component; replaced.</param>
    /// <param name="y">Component; replaced.</param>
    /// <param name="z">Component; replaced.</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void Normal<T>(ReadOnlySpan<double> inverseRows, ref T x, ref T y, ref T z)
        where T : unmanaged, IReal<T>
    {
        (x, y, z) = (Row(inverseRows, 0, 4, x, y, z), Row(inverseRows, 1, 4, x, y, z), Row(inverseRows, 2, 4, x, y, z));
        T length = T.Sqrt(Lane.Dot(x, y, z, x, y, z));
        T toUnit = T.Of(1) / T.Select(T.Less(T.Zero, length), length, T.Of(1));
        x *= toUnit;
        y *= toUnit;
        z *= toUnit;
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static T Row<T>(ReadOnlySpan<double> m, int at, int step, T x, T y, T z)
        where T : unmanaged, IReal<T> => T.Fma(T.Of(m[at]), x, T.Fma(T.Of(m[at + step]), y, T.Of(m[at + (2 * step)]) * z));
}
