using System.Runtime.CompilerServices;

namespace LabRaytracer;

/// <summary>The first hit of a sphere with twice the digits.</summary>
/// <typeparam name="R">Lane type of geometry.</typeparam>
[SkipLocalsInit]
internal readonly struct PreciseSphereHit<R>
    where R : unmanaged, IReal<R>
{
    /// <summary>Mask: there is a hit with t above 0.</summary>
    public readonly R IsHit;

    /// <summary>Ray parameter.</summary>
    public readonly R T;

    /// <summary>Mask: T is rounded correctly, and the hit is the first one.</summary>
    public readonly R IsExact;

    /// <summary>The point relative to the centre.</summary>
    public readonly R X, Y, Z;

    /// <remarks>
    /// a s² + 2 b s + c = 0 with a = d.d, b = l.d, c = l.l - r²; l is the point nearest to the centre, so that nothing cancels in -b ± root.
    /// With u the precision, b is within 11 u² |l| |d|, c within 22 u² (l² + r²), a within 6 u² a, hence the discriminant within 70 u² a (l² + r²), its root
    /// within that / root + 4 u² root, s within 81 u² (l² + r²) / root + 24 u² |s|, because root is at most |d| r, and t within 3 u² t more: all below 128.
    /// </remarks>
    [MethodImpl(MethodImplOptions.NoInlining)]
    public PreciseSphereHit(in RayLanes<R> ray, in R centerX, in R centerY, in R centerZ, in R radius, in R k)
    {
        PreciseLine<R> line = new(ray, centerX, centerY, centerZ, k);
        (R dx, R dy, R dz) = (ray.DirectionX, ray.DirectionY, ray.DirectionZ);
        DoubleWord<R> a = DoubleWord<R>.Product(dx, dx) + DoubleWord<R>.Product(dy, dy) + DoubleWord<R>.Product(dz, dz);
        DoubleWord<R> b = (line.X * dx) + (line.Y * dy) + (line.Z * dz);
        DoubleWord<R> c = (line.X * line.X) + (line.Y * line.Y) + (line.Z * line.Z) - DoubleWord<R>.Product(radius, radius);
        DoubleWord<R> discriminant = (b * b) - (a * c);
        DoubleWord<R> root = DoubleWord<R>.Sqrt(discriminant);
        DoubleWord<R> near = (-b - root) / a;
        DoubleWord<R> nearT = line.Parameter(near);
        R isNear = R.Less(R.Zero, nearT.High);
        DoubleWord<R> along = near, t = nearT;
        if (!R.All(isNear))
        {
            along = DoubleWord<R>.Select(isNear, near, (root - b) / a);
            t = line.Parameter(along);
        }

        T = t.High;
        (X, Y, Z) = line.Point(along);
        R unit = RoundedParameter.Unit<R>(), square = radius * radius, error = unit * (R.Abs(c.High) + square + square) / root.High;
        IsExact = R.Less(R.Fma(unit, R.Abs(near.High) + R.Abs(nearT.High), error), R.Abs(nearT.High))
            & RoundedParameter.IsCertain(t, R.Fma(unit, R.Abs(along.High) + R.Abs(T), error))
            & RoundedParameter.IsOrdinary(square) & RoundedParameter.IsOrdinary(a.High);
        IsHit = R.LessOrEqual(R.Zero, discriminant.High) & R.Less(R.Zero, T) & R.Less(T, R.Of(double.PositiveInfinity));
    }
}
