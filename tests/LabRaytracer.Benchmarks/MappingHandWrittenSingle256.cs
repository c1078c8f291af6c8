using System.Runtime.CompilerServices;
using System.Runtime.Intrinsics;

namespace LabRaytracer.Benchmarks;

/// <summary>The spherical mapping written by hand for 256-bit registers of float: what the generic form is measured against.</summary>
internal static unsafe class HandWrittenSingle256
{
    /// <summary>Maps points whose magnitudes are ordinary; false as soon as a group is not.</summary>
    public static bool Map(float* x, float* y, float* z, float* u, float* v, int count)
    {
        for (int i = 0; i < count; i += Vector256<float>.Count)
        {
            Vector256<float> px = Vector256.Load(x + i), py = Vector256.Load(y + i), pz = Vector256.Load(z + i);
            Vector256<float> ax = Vector256.Abs(px), ay = Vector256.Abs(py), az = Vector256.Abs(pz), sum = ax + az;
            if (!Vector256.LessThanOrEqualAll(Vector256.Create(1.8189894035458565e-12f), sum) || !Vector256.LessThanAll(sum + ay, Vector256.Create(1152921504606846976f)))
            {
                return false;
            }

            Vector256<float> larger = Vector256.MaxNative(ax, az), smaller = Vector256.MinNative(ax, az);
            Vector256<float> nearX = Vector256.LessThan(az, ax), behind = Vector256.LessThan(pz, Vector256<float>.Zero), left = Vector256.LessThan(px, Vector256<float>.Zero);
            Vector256<float> start = Vector256.ConditionalSelect(nearX, Vector256.Create(0.25f), behind & Vector256.Create(0.5f));
            start = Vector256.ConditionalSelect(left, Vector256<float>.One - start, start);
            Vector256<float> steep = Vector256.LessThan(larger * Vector256.Create(0.41421356237309503f), smaller);
            Vector256<float> numerator = Vector256.ConditionalSelect(steep, smaller - larger, smaller);
            Vector256<float> denominator = Vector256.ConditionalSelect(steep, smaller + larger, larger);
            Vector256<float> numeratorError = steep & (smaller - (numerator + larger));
            Vector256<float> denominatorError = steep & (smaller - (denominator - larger));
            Vector256<float> turns = AddAtan(start, nearX ^ behind ^ left, steep, numerator, denominator, numeratorError, denominatorError);
            Vector256.Store(Vector256.MinNative(turns, Vector256.Create(0.99999994f)), u + i);

            Vector256<float> large = larger * larger, small = smaller * smaller, square = large + small;
            Vector256<float> rest = (small - (square - large)) + (Vector256.FusedMultiplyAdd(larger, larger, -large) + Vector256.FusedMultiplyAdd(smaller, smaller, -small));
            Vector256<float> radius = Vector256.Sqrt(square);
            Vector256<float> error = (Vector256.FusedMultiplyAdd(-radius, radius, square) + rest) / (radius + radius);
            Vector256<float> low = Vector256.LessThanOrEqual(ay, radius), north = Vector256.LessThan(Vector256<float>.Zero, py);
            start = Vector256.ConditionalSelect(low, Vector256.Create(0.25f), north & Vector256.Create(0.5f));
            (smaller, larger) = (Vector256.MinNative(ay, radius), Vector256.MaxNative(ay, radius));
            steep = Vector256.LessThan(larger * Vector256.Create(0.41421356237309503f), smaller);
            numerator = Vector256.ConditionalSelect(steep, smaller - larger, smaller);
            denominator = Vector256.ConditionalSelect(steep, smaller + larger, larger);
            numeratorError = (steep & (smaller - (numerator + larger))) + Vector256.ConditionalSelect(low, -(steep & error), error);
            denominatorError = (steep & (smaller - (denominator - larger))) + ((low | steep) & error);
            turns = AddAtan(start, north ^ low, steep, numerator, denominator, numeratorError, denominatorError);
            Vector256.Store(turns + turns, v + i);
        }

        return true;
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Vector256<float> AddAtan(Vector256<float> start, Vector256<float> minus, Vector256<float> steep, Vector256<float> numerator, Vector256<float> denominator, Vector256<float> numeratorError, Vector256<float> denominatorError)
    {
        Vector256<float> inverse = Vector256<float>.One / denominator, q = numerator * inverse;
        Vector256<float> residual = Vector256.FusedMultiplyAdd(-q, denominator, numerator) + numeratorError;
        Vector256<float> qError = Vector256.FusedMultiplyAdd(-q, denominatorError, residual) * inverse;

        Vector256<float> s = q * q, s2 = s * s;
        Vector256<float> even = Vector256.FusedMultiplyAdd(Vector256.Create(-0.009673409163951874f), s2, Vector256.Create(-0.022669268772006035f));
        even = Vector256.FusedMultiplyAdd(even, s2, Vector256.Create(-0.05305161699652672f));
        Vector256<float> odd = Vector256.FusedMultiplyAdd(Vector256.Create(0.016860434785485268f), s2, Vector256.Create(0.03182855620980263f));
        Vector256<float> tail = Vector256.FusedMultiplyAdd(s, Vector256.FusedMultiplyAdd(odd, s, even), Vector256.Create(6.4206382432985265e-09f));
        Vector256<float> sign = minus & Vector256.Create(-0.0f), leading = Vector256.Create(0.15915494309189535f);
        Vector256<float> origin = start + ((steep & Vector256.Create(0.125f)) ^ sign);
        q ^= sign;
        Vector256<float> product = q * leading, sum = origin + product;
        Vector256<float> rest = Vector256.FusedMultiplyAdd(q, leading, -product) + (product - (sum - origin));
        return sum + Vector256.FusedMultiplyAdd(qError ^ sign, leading, Vector256.FusedMultiplyAdd(q, tail, rest));
    }
}
