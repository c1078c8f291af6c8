using System.Runtime.CompilerServices;

namespace LabRaytracer;

/// <summary>The first hit of an upright cone with twice the digits.</summary>
/// <typeparam name="R">Lane type of geometry.</typeparam>
internal readonly struct PreciseConeHit<R>
    where R : unmanaged, IReal<R>
{
    /// <summary>Mask: there is a hit with t above 0.</summary>
    public readonly R IsHit;

    /// <summary>Mask: it is on the base.</summary>
    public readonly R IsBase;

    /// <summary>Ray parameter.</summary>
    public readonly R T;

    /// <summary>The point relative to the apex.</summary>
    public readonly R X, Y, Z;

    /// <remarks>The quadratic of <see cref="ConeChoice{R}"/>, times the square of the height: no quotient is needed before the roots.</remarks>
    /// <param name="ray">The rays.</param>
    /// <param name="line">The same rays from near the apex.</param>
    /// <param name="radius">Radius of the base.</param>
    /// <param name="height">Height.</param>
    /// <param name="hasBase">1 for a base, 0 for none.</param>
    [MethodImpl(MethodImplOptions.NoInlining)]
    public PreciseConeHit(in RayLanes<R> ray, in PreciseLine<R> line, in R radius, in R height, in R hasBase)
    {
        (R dx, R dy, R dz) = (ray.DirectionX, ray.DirectionY, ray.DirectionZ);
        DoubleWord<R> wide = DoubleWord<R>.Product(height, height), narrow = DoubleWord<R>.Product(radius, radius);
        DoubleWord<R> a = (wide * (DoubleWord<R>.Product(dx, dx) + DoubleWord<R>.Product(dz, dz))) - (narrow * DoubleWord<R>.Product(dy, dy));
        DoubleWord<R> b = (wide * ((line.X * dx) + (line.Z * dz))) - (narrow * (line.Y * dy));
        DoubleWord<R> c = (wide * ((line.X * line.X) + (line.Z * line.Z))) - (narrow * (line.Y * line.Y));
        DoubleWord<R> discriminant = (b * b) - (a * c);
        DoubleWord<R> root = DoubleWord<R>.Sqrt(discriminant);
        DoubleWord<R> q = DoubleWord<R>.Select(R.Less(b.High, R.Zero), root - b, -b - root);
        DoubleWord<R> zero = new(R.Zero, R.Zero), end = new(height, R.Zero), rim = new(radius, R.Zero);
        R isReal = R.LessOrEqual(R.Zero, discriminant.High);
        DoubleWord<R> along = new(R.Of(double.PositiveInfinity), R.Zero);
        R isHit = R.Zero, isBase = R.Zero;
        foreach (DoubleWord<R> place in (ReadOnlySpan<DoubleWord<R>>)[q / a, c / q])
        {
            DoubleWord<R> y = line.Y + (place * dy);
            R isOn = isReal & R.LessOrEqual((y - zero).High, R.Zero) & R.LessOrEqual(R.Zero, (y + end).High) & IsAhead(line, place);
            Take(isOn, place, R.Zero, ref along, ref isHit, ref isBase);
        }

        DoubleWord<R> floor = (-end - line.Y) / new DoubleWord<R>(dy, R.Zero);
        DoubleWord<R> x = line.X + (floor * dx), z = line.Z + (floor * dz);
        R isInside = R.LessOrEqual(((x * x) + (z * z) - (rim * rim)).High, R.Zero) & R.Less(R.Zero, hasBase) & IsAhead(line, floor);
        Take(isInside, floor, R.True, ref along, ref isHit, ref isBase);
        (IsHit, IsBase) = (isHit, isBase);
        T = line.Parameter(along).High;
        (X, Y, Z) = line.Point(along);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static R IsAhead(in PreciseLine<R> line, in DoubleWord<R> place)
    {
        R t = line.Parameter(place).High;
        return R.Less(R.Zero, t) & R.Less(t, R.Of(double.PositiveInfinity));
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void Take(R mask, in DoubleWord<R> place, R isOnBase, ref DoubleWord<R> along, ref R isHit, ref R isBase)
    {
        R nearer = mask & (~isHit | R.Less((place - along).High, R.Zero));
        along = DoubleWord<R>.Select(nearer, place, along);
        isBase = R.Select(nearer, isOnBase, isBase);
        isHit |= mask;
    }
}
