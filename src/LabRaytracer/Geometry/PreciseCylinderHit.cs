using System.Runtime.CompilerServices;

namespace LabRaytracer;

/// <summary>The first hit of the side of an upright cylinder with twice the digits.</summary>
/// <typeparam name="R">Lane type of geometry.</typeparam>
internal readonly struct PreciseCylinderHit<R>
    where R : unmanaged, IReal<R>
{
    /// <summary>Mask: there is a hit with t above 0 between the ends.</summary>
    public readonly R IsHit;

    /// <summary>Ray parameter.</summary>
    public readonly R T;

    /// <summary>The point relative to the centre.</summary>
    public readonly R X, Y, Z;

    /// <remarks>a s² + 2 b s + c = 0 with a = d.d, b = l.d, c = l.l - r², all in (x, z); one root is q / a, the other c / q, so that rays along the axis keep the one that matters.</remarks>
    [MethodImpl(MethodImplOptions.NoInlining)]
    public PreciseCylinderHit(in RayLanes<R> ray, R centerX, R centerY, R centerZ, R radius, R halfHeight, R k)
    {
        PreciseLine<R> line = new(ray, centerX, centerY, centerZ, k);
        (R dx, R dy, R dz) = (ray.DirectionX, ray.DirectionY, ray.DirectionZ);
        DoubleWord<R> a = DoubleWord<R>.Product(dx, dx) + DoubleWord<R>.Product(dz, dz);
        DoubleWord<R> b = (line.X * dx) + (line.Z * dz);
        DoubleWord<R> c = (line.X * line.X) + (line.Z * line.Z) - DoubleWord<R>.Product(radius, radius);
        DoubleWord<R> discriminant = (b * b) - (a * c);
        DoubleWord<R> root = DoubleWord<R>.Sqrt(discriminant);
        DoubleWord<R> q = DoubleWord<R>.Select(R.Less(b.High, R.Zero), root - b, -b - root);
        DoubleWord<R> byA = q / a, byQ = c / q;

        // c / 0 is no number and loses every comparison.
        DoubleWord<R> near = DoubleWord<R>.Select(R.Less(byQ.High, byA.High), byQ, byA);
        DoubleWord<R> far = DoubleWord<R>.Select(R.Less(byA.High, byQ.High), byQ, byA);
        R isNear = IsAhead(line, near, dy, halfHeight);
        IsHit = R.LessOrEqual(R.Zero, discriminant.High) & (isNear | IsAhead(line, far, dy, halfHeight));
        DoubleWord<R> along = DoubleWord<R>.Select(isNear, near, far);
        T = line.Parameter(along);
        (X, Y, Z) = line.Point(along);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static R IsAhead(in PreciseLine<R> line, in DoubleWord<R> along, R dy, R halfHeight)
    {
        R t = line.Parameter(along);
        DoubleWord<R> y = line.Y + (along * dy), end = new(halfHeight, R.Zero);
        R isBetween = R.LessOrEqual((y - end).High, R.Zero) & R.LessOrEqual(R.Zero, (y + end).High);
        return R.Less(R.Zero, t) & R.Less(t, R.Of(double.PositiveInfinity)) & isBetween;
    }
}
