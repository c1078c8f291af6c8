using System.Runtime.CompilerServices;

namespace LabRaytracer;

/// <summary>The map of the unit square to the unit disk that keeps neighbours together and areas in proportion: squares around the middle become circles.</summary>
internal static class SquareDisk
{
    /// <summary>The point of the disk of radius 1.</summary>
    /// <remarks>
    /// With a = 2 s - 1 and b = 2 t - 1: radius a and angle pi / 4 b / a where |a| &gt; |b|, else radius b and angle pi / 2 - pi / 4 a / b
    /// (Shirley and Chiu, A low distortion map between disk and square, 1997).
    /// </remarks>
    /// <param name="s">First coordinate, [0, 1].</param>
    /// <param name="t">Second coordinate, [0, 1].</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static (R X, R Y) At<R>(R s, R t)
        where R : unmanaged, IReal<R>
    {
        R one = R.Of(1), eighth = R.Of(0.125);
        R a = (s + s) - one, b = (t + t) - one;
        R isWide = R.Less(R.Abs(b), R.Abs(a));
        R radius = R.Select(isWide, a, b);
        R ratio = R.Select(isWide, b, a) / R.Select(R.Equal(radius, R.Zero), one, radius);
        (R sin, R cos) = Elementary.SinCosTurns(R.Select(isWide, eighth * ratio, R.Of(0.25) - (eighth * ratio)));
        return (radius * cos, radius * sin);
    }
}
