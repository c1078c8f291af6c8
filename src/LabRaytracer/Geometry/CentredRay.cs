using System.Runtime.CompilerServices;

namespace LabRaytracer;

/// <summary>Rays seen from a shape's centre: each starts at its point nearest to the centre instead of at its far origin.</summary>
/// <typeparam name="R">Lane type of geometry.</typeparam>
/// <remarks>
/// The points are L + s D with L = o - c + k D; the ray parameter is t = k + s. L keeps all digits at any distance, because the difference o - c is
/// carried in two parts and k D cancels against it inside one fused multiply-add. Whatever k's own rounding is, L lies on the ray.
/// A formula that uses L and s alone is as accurate for a far camera as for a near one.
/// </remarks>
internal struct CentredRay<R>
    where R : unmanaged, IReal<R>
{
    /// <summary>Ray parameter of L.</summary>
    public R K;

    /// <summary>L, relative to the centre; perpendicular to the direction up to the rounding of <see cref="K"/>.</summary>
    public R X, Y, Z;

    /// <summary>Direction, as given.</summary>
    public R DirectionX, DirectionY, DirectionZ;

    /// <summary>1 / D.D.</summary>
    public R InverseLengthSquared;

    /// <summary>Rays seen from a centre.</summary>
    /// <param name="ray">The rays.</param>
    /// <param name="shape">Numbers of shapes.</param>
    /// <param name="center">Which of them is x of the centre; y and z follow.</param>
    /// <param name="centred">The same rays.</param>
    /// <remarks>No constructor: the compiler would clear its result first, make it elsewhere and copy it.</remarks>
    [MethodImpl(MethodImplOptions.NoInlining)]
    public static void Of<P>(in RayLanes<R> ray, in P shape, int center, out CentredRay<R> centred)
        where P : struct, IParameters<R>
    {
        Unsafe.SkipInit(out centred);
        R dx = ray.DirectionX, dy = ray.DirectionY, dz = ray.DirectionZ;
        R x = Compensated.Difference(ray.OriginX, shape[center], out R restX);
        R y = Compensated.Difference(ray.OriginY, shape[center + 1], out R restY);
        R z = Compensated.Difference(ray.OriginZ, shape[center + 2], out R restZ);
        R inverse = R.Of(1) / Lane.Dot(dx, dy, dz, dx, dy, dz);
        R k = -Lane.Dot(x, y, z, dx, dy, dz) * inverse;
        centred.K = k;
        centred.InverseLengthSquared = inverse;
        centred.DirectionX = dx;
        centred.DirectionY = dy;
        centred.DirectionZ = dz;
        centred.X = R.Fma(k, dx, x) + restX;
        centred.Y = R.Fma(k, dy, y) + restY;
        centred.Z = R.Fma(k, dz, z) + restZ;
    }
}
