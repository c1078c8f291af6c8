using System.Runtime.CompilerServices;

namespace LabRaytracer;

/// <content>Where rounding may decide, or shows.</content>
internal readonly unsafe partial struct SphereKernel
{
    public static bool MayMeet(ReadOnlySpan<double> numbers, in RayBounds bounds) =>
        bounds.MayMeetSphere(new Point3D(numbers[CenterX], numbers[CenterY], numbers[CenterZ]), numbers[Radius]);

    /// <remarks>
    /// With u = 2^-24 and |.| the sum of absolute coordinates, the rounded difference o - c is wrong by at most 2u(|o| + |c|) in length, and the nearest point l,
    /// whose steps are no longer than that difference, by at most 8u(|o| + |c|). A sphere grown by twice that, e = 16u(|o| + |c|), and 16u of its square
    /// for the squares, misses no ray that meets the sphere.
    /// </remarks>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static F MayHit<F, P>(in P shape, in RayLanes<F> ray)
        where F : unmanaged, IReal<F>
        where P : struct, IParameters<F>
    {
        F cx = shape[CenterX], cy = shape[CenterY], cz = shape[CenterZ];
        F x = ray.OriginX - cx, y = ray.OriginY - cy, z = ray.OriginZ - cz;
        F size = F.Abs(ray.OriginX) + F.Abs(ray.OriginY) + F.Abs(ray.OriginZ) + F.Abs(cx) + F.Abs(cy) + F.Abs(cz);

        // 1e-18 more, so that squares of tiny numbers do not underflow.
        F radius = F.Fma(size, F.Of(16.0 / (1 << 24)), shape[Radius]) + F.Of(1e-18);
        F square = radius * radius * F.Of(1 + (16.0 / (1 << 24)));
        F lengthSquared = Lane.Dot(ray.DirectionX, ray.DirectionY, ray.DirectionZ, ray.DirectionX, ray.DirectionY, ray.DirectionZ);
        F along = Lane.Dot(x, y, z, ray.DirectionX, ray.DirectionY, ray.DirectionZ);
        F k = -along / lengthSquared;
        F lx = F.Fma(k, ray.DirectionX, x), ly = F.Fma(k, ray.DirectionY, y), lz = F.Fma(k, ray.DirectionZ, z);
        F passesBy = F.Less(square, Lane.Dot(lx, ly, lz, lx, ly, lz));
        F isBehind = F.Less(F.Zero, along) & F.Less(square * lengthSquared, along * along);
        return ~(passesBy | isBehind);
    }

    /// <summary>Mask: the discriminant, or the product of both ray parameters (how far outside the ray starts), is too near 0 for its sign to be certain.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static R IsClose<R>(in CentredRay<R> ray, R radius, R discriminant, R near, R far)
        where R : unmanaged, IReal<R>
    {
        R unit = radius * radius * R.Of(R.IsSingle ? 16.0 / (1 << 24) : 16.0 / (1L << 53));
        R start = R.Abs(near * far);
        return R.LessOrEqual(R.Abs(discriminant), unit) | R.LessOrEqual(start, unit * ray.InverseLengthSquared);
    }

    /// <summary>Mask: half the chord is so short that its error shows in the point, or the decision was close.</summary>
    /// <param name="ray">Rays from their points nearest to the centre.</param>
    /// <param name="radius">Radius.</param>
    /// <param name="discriminant">Squared half chord, object units.</param>
    /// <param name="near">Ray parameter of the chord's beginning.</param>
    /// <param name="far">Ray parameter of its end.</param>
    /// <param name="half">Half the chord in units of the direction.</param>
    /// <remarks>
    /// The error of half the chord is a few units of r^2 / half. Up to half = r / 20 it keeps the point within 1e-11 texel of a picture 8192 texels wide.
    /// The masks depend on nothing but the ray and the shape, so that whoever asks gets the same answer.
    /// </remarks>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static R IsRough<R>(in CentredRay<R> ray, R radius, R discriminant, R near, R far, R half)
        where R : unmanaged, IReal<R>
    {
        R isRough = ~R.LessOrEqual(Square(ray, radius), R.Of(400) * half * half) | IsClose(ray, radius, discriminant, near, far);

        // Floats have no digits to spare: on a ground as large as the earth, three units of the radius are seen where rays start near to it.
        return R.IsSingle ? IsHardT(ray, radius, near, far, half, isRough, out _) : isRough;
    }

    /// <summary>Mask: the error of half the chord shows in t, and takes twice the digits; so do all rough points, which in float lanes are the same. Up to r^2 / half = t it keeps t within 2.5 units.</summary>
    /// <param name="ray">Rays from their points nearest to the centre.</param>
    /// <param name="radius">Radius.</param>
    /// <param name="near">Ray parameter of the chord's beginning.</param>
    /// <param name="far">Ray parameter of its end.</param>
    /// <param name="half">Half the chord in units of the direction.</param>
    /// <param name="isRough">Mask: the point is rough.</param>
    /// <param name="isRoughT">Mask: the error shows in t, and the ray starts far enough from its hit for <see cref="CompensatedChord{R}"/>.</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static R IsHardT<R>(in CentredRay<R> ray, R radius, R near, R far, R half, R isRough, out R isRoughT)
        where R : unmanaged, IReal<R>
    {
        R t = R.Abs(R.Select(R.Less(R.Zero, near), near, far)), square = Square(ray, radius);

        // From within one and a half chords of the hit, the error of half the chord is a larger part of t.
        R shows = R.Less(half * R.Select(R.Less(t, R.Of(3) * half), R.Of(0.5) * t, t), square);
        R isHard = isRough | (shows & ~R.LessOrEqual(square, R.Of(0.25) * t * t));
        isRoughT = shows & ~isHard;
        return isHard;
    }

    /// <summary>The squared radius in units of the direction.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static R Square<R>(in CentredRay<R> ray, R radius)
        where R : unmanaged, IReal<R> => radius * radius * ray.InverseLengthSquared;

    /// <summary>Hit or miss, and t, of the lanes of a mask with twice the digits; the others stay.</summary>
    [MethodImpl(MethodImplOptions.NoInlining)]
    private static R Decide<R, P>(in P shape, in RayLanes<R> ray, in R k, in R mask, in R hit, ref R t)
        where R : unmanaged, IReal<R>
        where P : struct, IParameters<R>
    {
        PreciseSphereHit<R> precise = new(ray, shape[CenterX], shape[CenterY], shape[CenterZ], shape[Radius], k);
        t = R.Select(mask, precise.T, t);
        return R.Select(mask, precise.IsHit, hit);
    }
}
