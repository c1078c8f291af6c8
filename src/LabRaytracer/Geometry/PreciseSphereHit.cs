using System.Runtime.CompilerServices;

namespace LabRaytracer;

/// <summary>The first hit of a sphere with twice the digits.</summary>
/// <typeparam name="R">Lane type of geometry.</typeparam>
internal readonly struct PreciseSphereHit<R>
    where R : unmanaged, IReal<R>
{
    /// <summary>Mask: there is a hit with t above 0.</summary>
    public readonly R IsHit;

    /// <summary>Ray parameter.</summary>
    public readonly R T;

    /// <summary>The point relative to the centre.</summary>
    public readonly R X, Y, Z;

    /// <remarks>a s² + 2 b s + c = 0 with a = d.d, b = l.d, c = l.l - r²; l is the point nearest to the centre, so that nothing cancels in -b ± root.</remarks>
    [MethodImpl(MethodImplOptions.NoInlining)]
    public PreciseSphereHit(in RayLanes<R> ray, R centerX, R centerY, R centerZ, R radius, R k)
    {
        PreciseLine<R> line = new(ray, centerX, centerY, centerZ, k);
        (R dx, R dy, R dz) = (ray.DirectionX, ray.DirectionY, ray.DirectionZ);
        DoubleWord<R> a = DoubleWord<R>.Product(dx, dx) + DoubleWord<R>.Product(dy, dy) + DoubleWord<R>.Product(dz, dz);
        DoubleWord<R> b = (line.X * dx) + (line.Y * dy) + (line.Z * dz);
        DoubleWord<R> c = (line.X * line.X) + (line.Y * line.Y) + (line.Z * line.Z) - DoubleWord<R>.Product(radius, radius);
        DoubleWord<R> discriminant = (b * b) - (a * c);
        DoubleWord<R> root = DoubleWord<R>.Sqrt(discriminant);
        DoubleWord<R> near = (-b - root) / a, far = (root - b) / a;
        R isNear = R.Less(R.Zero, line.Parameter(near));
        DoubleWord<R> along = DoubleWord<R>.Select(isNear, near, far);
        T = line.Parameter(along);
        (X, Y, Z) = line.Point(along);
        IsHit = R.LessOrEqual(R.Zero, discriminant.High) & R.Less(R.Zero, T) & R.Less(T, R.Of(double.PositiveInfinity));
    }
}
