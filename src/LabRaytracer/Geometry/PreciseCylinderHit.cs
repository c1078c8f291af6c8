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

    /// <summary>Mask: T is rounded correctly, and the hit is the first one between the ends.</summary>
    public readonly R IsExact;

    /// <summary>The point relative to the centre.</summary>
    public readonly R X, Y, Z;

    /// <remarks>
    /// a s² + 2 b s + c = 0 with a = d.d, b = l.d, c = l.l - r², all in (x, z); one root is q / a, the other c / q, so that rays along the axis keep the one that matters.
    /// Error bounds as in <see cref="PreciseSphereHit{R}"/>; those of c / q are 22 u² (l² + r²) / q of c and, q / a being the larger root, 81 u² (l² + r²) / root of q.
    /// </remarks>
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
        R unit = RoundedParameter.Unit<R>(), square = radius * radius, error = unit * (R.Abs(c.High) + square + square) / root.High;
        R isNear = IsAhead(line, near, dy, halfHeight, error, out R nearIsSure);
        R isFar = IsAhead(line, far, dy, halfHeight, error, out R farIsSure);
        IsHit = R.LessOrEqual(R.Zero, discriminant.High) & (isNear | isFar);
        DoubleWord<R> along = DoubleWord<R>.Select(isNear, near, far), t = line.Parameter(along);
        T = t.High;
        (X, Y, Z) = line.Point(along);
        IsExact = nearIsSure & farIsSure & RoundedParameter.IsCertain(t, R.Fma(unit, R.Abs(along.High) + R.Abs(T), error))
            & RoundedParameter.IsOrdinary(square) & RoundedParameter.IsOrdinary(a.High);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static R IsAhead(in PreciseLine<R> line, in DoubleWord<R> along, R dy, R halfHeight, R error, out R isSure)
    {
        R t = line.Parameter(along).High;
        DoubleWord<R> way = along * dy, y = line.Y + way, end = new(halfHeight, R.Zero);
        R above = (y - end).High, below = (y + end).High, unit = RoundedParameter.Unit<R>();
        R errorOfT = R.Fma(unit, R.Abs(along.High) + R.Abs(t), error);
        R errorOfY = R.Fma(unit, R.Abs(line.Y.High) + R.Abs(way.High) + halfHeight, errorOfT * R.Abs(dy));
        isSure = R.Less(errorOfT, R.Abs(t)) & R.Less(errorOfY, R.Abs(above)) & R.Less(errorOfY, R.Abs(below));
        return R.Less(R.Zero, t) & R.Less(t, R.Of(double.PositiveInfinity)) & R.LessOrEqual(above, R.Zero) & R.LessOrEqual(R.Zero, below);
    }
}
