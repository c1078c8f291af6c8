using System.Runtime.CompilerServices;

namespace LabRaytracer;

/// <summary>Rays seen from a shape's centre: each starts at its point nearest to the centre instead of at its far origin.</summary>
/// <typeparam name="R">Lane type of geometry.</typeparam>
/// <remarks>
/// The points are L + s D with L = o - c + k D; the ray parameter is t = k + s. L keeps all digits at any distance, because the difference o - c is
/// carried in two parts and k D cancels against it inside one fused multiply-add. Whatever k's own rounding is, L lies on the ray.
/// A formula that uses L and s alone is as accurate for a far camera as for a near one.
/// </remarks>
internal readonly struct CentredRay<R>
    where R : unmanaged, IReal<R>
{
    /// <summary>Ray parameter of L.</summary>
    public readonly R K;

    /// <summary>L, relative to the centre; perpendicular to the direction up to the rounding of <see cref="K"/>.</summary>
    public readonly R X, Y, Z;

    /// <summary>Direction, as given.</summary>
    public readonly R DirectionX, DirectionY, DirectionZ;

    /// <summary>1 / D.D.</summary>
    public readonly R InverseLengthSquared;

    [MethodImpl(MethodImplOptions.NoInlining)]
    public CentredRay(in RayLanes<R> ray, in R centerX, in R centerY, in R centerZ)
    {
        (DirectionX, DirectionY, DirectionZ) = (ray.DirectionX, ray.DirectionY, ray.DirectionZ);
        R x = Compensated.Difference(ray.OriginX, centerX, out R restX);
        R y = Compensated.Difference(ray.OriginY, centerY, out R restY);
        R z = Compensated.Difference(ray.OriginZ, centerZ, out R restZ);
        InverseLengthSquared = R.Of(1) / Lane.Dot(DirectionX, DirectionY, DirectionZ, DirectionX, DirectionY, DirectionZ);
        K = -Lane.Dot(x, y, z, DirectionX, DirectionY, DirectionZ) * InverseLengthSquared;
        X = R.Fma(K, DirectionX, x) + restX;
        Y = R.Fma(K, DirectionY, y) + restY;
        Z = R.Fma(K, DirectionZ, z) + restZ;
    }
}
