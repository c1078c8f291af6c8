using System.Runtime.CompilerServices;

namespace LabRaytracer;

/// <summary>The first ray parameter on a sphere from half a chord that keeps its digits however short it is: what rounding drops is summed beside.</summary>
/// <typeparam name="R">Lane type of geometry.</typeparam>
/// <remarks>A tenth of the cost of <see cref="PreciseSphereHit{R}"/>, for rays that start at least two radii before their hit and whose decisions are not close.</remarks>
[SkipLocalsInit]
internal readonly struct CompensatedChord<R>
    where R : unmanaged, IReal<R>
{
    /// <summary>Ray parameter.</summary>
    public readonly R T;

    [MethodImpl(MethodImplOptions.NoInlining)]
    public CompensatedChord(in RayLanes<R> ray, in R centerX, in R centerY, in R centerZ, in R radius, in R k, in R inverseLengthSquared)
    {
        (R dx, R dy, R dz) = (ray.DirectionX, ray.DirectionY, ray.DirectionZ);
        R x = Move(ray.OriginX, centerX, k, dx, out R lowX);
        R y = Move(ray.OriginY, centerY, k, dy, out R lowY);
        R z = Move(ray.OriginZ, centerZ, k, dz, out R lowZ);
        R along = Compensated.Dot(x, y, z, dx, dy, dz, out R alongRest);
        along += alongRest + Lane.Dot(lowX, lowY, lowZ, dx, dy, dz);
        R step = -along * inverseLengthSquared;
        R square = Compensated.Dot(x, y, z, x, y, z, out R squareRest);
        squareRest = R.Fma(R.Of(2), Lane.Dot(x, y, z, lowX, lowY, lowZ), squareRest);
        R radiusSquare = radius * radius;
        R discriminant = Compensated.Difference(radiusSquare, square, out R rest);
        rest += R.Fma(radius, radius, -radiusSquare) - squareRest;
        discriminant += R.Fma(-step, along, rest);
        R half = R.Sqrt(R.Max(discriminant * inverseLengthSquared, R.Zero));
        R near = k + (step - half);
        T = R.Select(R.Less(R.Zero, near), near, k + (step + half));
    }

    /// <summary>One coordinate of o - c + k d in two parts.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static R Move(R origin, R center, R k, R direction, out R low)
    {
        R offset = Compensated.Difference(origin, center, out R offsetRest);
        R way = k * direction;
        R sum = Compensated.Difference(way, -offset, out R sumRest);
        low = sumRest + (R.Fma(k, direction, -way) + offsetRest);
        R high = sum + low;
        low -= high - sum;
        return high;
    }
}
