using System.Runtime.CompilerServices;

namespace LabRaytracer;

/// <summary>Directions by azimuth and height.</summary>
internal static class SkyDirection
{
    /// <summary>Unit vectors (sin theta sin phi, cos theta, sin theta cos phi): those that <see cref="SphericalMapping"/> maps to u = phi / 2 pi, v = 1 - theta / pi.</summary>
    /// <param name="turns">phi / 2 pi.</param>
    /// <param name="cosine">cos theta, [-1, 1].</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static (R X, R Y, R Z) At<R>(R turns, R cosine)
        where R : unmanaged, IReal<R>
    {
        R one = R.Of(1);
        R across = R.Sqrt(R.Max((one - cosine) * (one + cosine), R.Zero));
        (R sin, R cos) = Elementary.SinCosTurns(turns);
        return (across * sin, cosine, across * cos);
    }
}
