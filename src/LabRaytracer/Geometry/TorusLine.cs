using System.Runtime.CompilerServices;

namespace LabRaytracer;

/// <summary>Rays in units of a torus' ring: points are L + tau D with D of length 1 and L perpendicular to it.</summary>
/// <typeparam name="R">Lane type of geometry.</typeparam>
internal readonly struct TorusLine<R>
    where R : unmanaged, IReal<R>
{
    /// <summary>Radius of the tube.</summary>
    public readonly R Tube;

    /// <summary>Length of one unit of tau in steps of the ray.</summary>
    public readonly R Scale;

    /// <summary>Squared length of L.</summary>
    public readonly R DistanceSquared;

    private readonly R _x, _y, _z;
    private readonly R _directionX, _directionY, _directionZ;
    private readonly R _middle;

    [MethodImpl(MethodImplOptions.NoInlining)]
    public TorusLine(in CentredRay<R> ray, in R ring, in R tube)
    {
        R toUnit = R.Sqrt(ray.InverseLengthSquared), toRing = R.Of(1) / ring;
        (_directionX, _directionY, _directionZ) = (ray.DirectionX * toUnit, ray.DirectionY * toUnit, ray.DirectionZ * toUnit);
        (R x, R y, R z) = (ray.X * toRing, ray.Y * toRing, ray.Z * toRing);

        // What rounding left of the component along the ray.
        _middle = -Lane.Dot(x, y, z, _directionX, _directionY, _directionZ);
        _x = R.Fma(_middle, _directionX, x);
        _y = R.Fma(_middle, _directionY, y);
        _z = R.Fma(_middle, _directionZ, z);
        DistanceSquared = Lane.Dot(_x, _y, _z, _x, _y, _z);
        Tube = tube * toRing;
        Scale = ring * toUnit;
    }

    /// <summary>Steps of the ray from its nearest point.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public R Along(R tau) => (tau + _middle) * Scale;

    /// <summary>Tau of a number of steps of the ray from its nearest point.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public R Tau(R along) => (along / Scale) - _middle;

    /// <summary>
    /// Coefficients p, q of tau³ + p tau + q, a quarter of the derivative of (|P|² + 1 - tube²)² - 4 (x² + z²): its zeros are the extrema of the quartic.
    /// </summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public (R P, R Q) Extrema()
    {
        R flat = R.Fma(_directionX, _directionX, _directionZ * _directionZ);
        R slope = R.Fma(_x, _directionX, _z * _directionZ);
        R constant = (DistanceSquared - (flat + flat)) + R.Fma(-Tube, Tube, R.Of(1));
        return (constant, slope * R.Of(-2));
    }

    /// <summary>
    /// (sqrt(x² + z²) - 1)² + y² - tube²: above 0 outside of the tube, below 0 inside. It has the sign of the quartic, but none of its cancellation, however thin the tube.
    /// </summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public R Outside(R tau, out R slope)
    {
        R x = R.Fma(tau, _directionX, _x), y = R.Fma(tau, _directionY, _y), z = R.Fma(tau, _directionZ, _z);
        R distance = R.Sqrt(R.Fma(x, x, z * z)), outward = distance - R.Of(1);
        R flat = R.Fma(x, _directionX, z * _directionZ) / R.Max(distance, R.Of(1e-30));
        R half = R.Fma(outward, flat, y * _directionY);
        slope = half + half;

        // As a difference of squares: outward and y are as small as the tube.
        return R.Fma(outward, outward, R.Fma(y, y, -(Tube * Tube)));
    }
}
