using System.Runtime.CompilerServices;

namespace LabRaytracer;

/// <content>Where rounding may decide, or shows.</content>
internal readonly unsafe partial struct SphereKernel
{
    public static bool MayMeet(ReadOnlySpan<double> numbers, in RayBounds bounds) =>
        bounds.MayMeetSphere(new Point3D(numbers[CenterX], numbers[CenterY], numbers[CenterZ]), numbers[Radius]);

    /// <summary>Mask: the discriminant, or the product of both ray parameters (how far outside the ray starts), is too near 0 for its sign to be certain.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static R IsClose<R>(in CentredRay<R> ray, R radius, R discriminant, R near, R far)
        where R : unmanaged, IReal<R>
    {
        R unit = radius * radius * R.Of(R.IsSingle ? 16.0 / (1 << 24) : 16.0 / (1L << 53));
        R start = R.Abs(near * far);
        return R.LessOrEqual(R.Abs(discriminant), unit) | R.LessOrEqual(start, unit * ray.InverseLengthSquared);
    }

    /// <summary>Mask: half the chord is so short that its error shows in the point, the ray starts so near that it shows in t, or the decision was close.</summary>
    /// <param name="ray">Rays from their points nearest to the centre.</param>
    /// <param name="radius">Radius.</param>
    /// <param name="discriminant">Squared half chord, object units.</param>
    /// <param name="step">From l to the middle of the chord.</param>
    /// <param name="half">Half the chord in units of the direction.</param>
    /// <param name="isRoughT">Mask: its error shows in t alone, or in both, and the ray starts far enough.</param>
    /// <remarks>
    /// The error of half the chord is a few units of r^2 / half. Up to r^2 / half = t it keeps t within 2.5 units; up to half = r / 20 it keeps the point within
    /// 1e-11 texel of a picture 8192 texels wide. The masks depend on nothing but the ray and the shape, so that whoever asks gets the same answer.
    /// </remarks>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static R IsRough<R>(in CentredRay<R> ray, R radius, R discriminant, R step, R half, out R isRoughT)
        where R : unmanaged, IReal<R>
    {
        R near = ray.K + (step - half), far = ray.K + (step + half);
        R t = R.Abs(R.Select(R.Less(R.Zero, near), near, far));
        R square = radius * radius * ray.InverseLengthSquared;

        // From within one and a half chords of the hit, the error of half the chord is a larger part of t.
        isRoughT = R.Less(half * R.Select(R.Less(t, R.Of(3) * half), R.Of(0.5) * t, t), square);
        R isFine = R.LessOrEqual(square, R.Of(400) * half * half) & (R.LessOrEqual(square, R.Of(0.25) * t * t) | ~isRoughT);
        return ~isFine | IsClose(ray, radius, discriminant, near, far);
    }

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
