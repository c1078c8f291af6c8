using System.Runtime.CompilerServices;

namespace LabRaytracer;

/// <summary>A hit of a torus with twice the digits.</summary>
/// <typeparam name="R">Lane type of geometry.</typeparam>
internal readonly struct PreciseTorusHit<R>
    where R : unmanaged, IReal<R>
{
    /// <summary>Ray parameter.</summary>
    public readonly R T;

    /// <summary>The point relative to the centre.</summary>
    public readonly R X, Y, Z;

    /// <summary>Its distance from the axis minus the ring's radius.</summary>
    public readonly R Outward;

    /// <summary>Two steps of Newton's method: the first finds the digits that one word cannot hold, the second those of grazing hits.</summary>
    /// <param name="line">The rays.</param>
    /// <param name="ray">The same rays.</param>
    /// <param name="ring">Radius of the ring.</param>
    /// <param name="tube">Radius of the tube.</param>
    /// <param name="along">The hit as found with one word, steps from the rays' nearest points.</param>
    [MethodImpl(MethodImplOptions.NoInlining)]
    public PreciseTorusHit(in PreciseLine<R> line, in RayLanes<R> ray, in R ring, in R tube, in R along)
    {
        DoubleWord<R> place = new(along, R.Zero);
        for (int step = 0; step < 2; step++)
        {
            R correction = Correction(line, ray, ring, tube, place);
            place = place + new DoubleWord<R>(correction, R.Zero);
        }

        T = line.Parameter(place).High;
        (X, Y, Z) = line.Point(place);
        Outward = Locate(line, ray, ring, place, out _).High;
    }

    /// <summary>(sqrt(x² + z²) - ring)² + y² - tube², rounded once.</summary>
    [MethodImpl(MethodImplOptions.NoInlining)]
    public static R Outside(in PreciseLine<R> line, in RayLanes<R> ray, in R ring, in R tube, in DoubleWord<R> along)
    {
        DoubleWord<R> outward = Locate(line, ray, ring, along, out DoubleWord<R> y);
        return ((outward * outward) + (y * y) - DoubleWord<R>.Product(tube, tube)).High;
    }

    /// <summary>What Newton's method adds; nothing where the ray grazes so closely that the slope says nothing.</summary>
    [MethodImpl(MethodImplOptions.NoInlining)]
    private static R Correction(in PreciseLine<R> line, in RayLanes<R> ray, in R ring, in R tube, in DoubleWord<R> along)
    {
        R value = Outside(line, ray, ring, tube, along);
        (R x, R y, R z) = line.Point(along);
        R distance = R.Sqrt(R.Fma(x, x, z * z));
        R flat = R.Fma(x, ray.DirectionX, z * ray.DirectionZ) / distance;
        R slope = R.Of(2) * R.Fma(distance - ring, flat, y * ray.DirectionY);
        R step = -value / slope;
        R lengthSquared = Lane.Dot(ray.DirectionX, ray.DirectionY, ray.DirectionZ, ray.DirectionX, ray.DirectionY, ray.DirectionZ);
        R most = R.Of(R.IsSingle ? 1.0 / (1 << 8) : 1.0 / (1 << 20)) * tube;
        return R.LessOrEqual(step * step * lengthSquared, most * most) & step;
    }

    /// <summary>Distance from the axis minus the ring's radius, and height.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static DoubleWord<R> Locate(in PreciseLine<R> line, in RayLanes<R> ray, R ring, in DoubleWord<R> along, out DoubleWord<R> y)
    {
        DoubleWord<R> x = line.X + (along * ray.DirectionX), z = line.Z + (along * ray.DirectionZ);
        y = line.Y + (along * ray.DirectionY);
        return DoubleWord<R>.Sqrt((x * x) + (z * z)) - new DoubleWord<R>(ring, R.Zero);
    }
}
