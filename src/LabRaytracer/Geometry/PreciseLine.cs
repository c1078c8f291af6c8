using System.Runtime.CompilerServices;

namespace LabRaytracer;

/// <summary>Rays seen from a shape's centre with twice the digits: points are L + s D, the ray parameter is k + s.</summary>
/// <typeparam name="R">Lane type of geometry.</typeparam>
/// <remarks>For the few lanes where <see cref="CentredRay{R}"/> is not enough.</remarks>
internal readonly struct PreciseLine<R>
    where R : unmanaged, IReal<R>
{
    /// <summary>L, relative to the centre.</summary>
    public readonly DoubleWord<R> X, Y, Z;

    private readonly R _k;
    private readonly R _directionX, _directionY, _directionZ;

    /// <param name="ray">The rays.</param>
    /// <param name="centerX">Centre x.</param>
    /// <param name="centerY">Centre y.</param>
    /// <param name="centerZ">Centre z.</param>
    /// <param name="k">Ray parameter of L: any number, best that of the point nearest to the centre.</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public PreciseLine(in RayLanes<R> ray, R centerX, R centerY, R centerZ, R k)
    {
        (_k, _directionX, _directionY, _directionZ) = (k, ray.DirectionX, ray.DirectionY, ray.DirectionZ);
        X = Move(ray.OriginX, centerX, k, ray.DirectionX);
        Y = Move(ray.OriginY, centerY, k, ray.DirectionY);
        Z = Move(ray.OriginZ, centerZ, k, ray.DirectionZ);
    }

    /// <summary>The ray parameter.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public DoubleWord<R> Parameter(in DoubleWord<R> along) => new DoubleWord<R>(_k, R.Zero) + along;

    /// <summary>A point, relative to the centre, rounded.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public (R X, R Y, R Z) Point(in DoubleWord<R> along) => (
        (X + (along * _directionX)).High,
        (Y + (along * _directionY)).High,
        (Z + (along * _directionZ)).High);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static DoubleWord<R> Move(R origin, R center, R k, R direction) =>
        DoubleWord<R>.Product(k, direction) + DoubleWord<R>.Difference(origin, center);
}
