using System.Runtime.CompilerServices;
using System.Runtime.Intrinsics;

namespace LabRaytracer.Benchmarks;

/// <summary>The spherical mapping written by hand for 128-bit registers of float: what the generic form is measured against.</summary>
internal static unsafe class HandWrittenSingle128
{
    /// <summary>Maps points whose magnitudes are ordinary; false as soon as a group is not.</summary>
    public static bool Map(float* x, float* y, float* z, float* u, float* v, int count)
    {
        for (int i = 0; i < count; i += Vector128<float>.Count)
        {
            Vector128<float> px = Vector128.Load(x + i), py = Vector128.Load(y + i), pz = Vector128.Load(z + i);
            Vector128<float> ax = Vector128.Abs(px), ay = Vector128.Abs(py), az = Vector128.Abs(pz), sum = ax + az;
            if (!Vector128.LessThanOrEqualAll(Vector128.Create(1.8189894035458565e-12f), sum) || !Vector128.LessThanAll(sum + ay, Vector128.Create(1152921504606846976f)))
            {
                return false;
            }

            Vector128<float> larger = Vector128.MaxNative(ax, az), smaller = Vector128.MinNative(ax, az);
            Vector128<float> nearX = Vector128.LessThan(az, ax), behind = Vector128.LessThan(pz, Vector128<float>.Zero), left = Vector128.LessThan(px, Vector128<float>.Zero);
            Vector128<float> start = Vector128.ConditionalSelect(nearX, Vector128.Create(0.25f), behind & Vector128.Create(0.5f));
            start = Vector128.ConditionalSelect(left, Vector128<float>.One - start, start);
            Vector128<float> steep = Vector128.LessThan(larger * Vector128.Create(0.41421356237309503f), smaller);
            Vector128<float> numerator = Vector128.ConditionalSelect(steep, smaller - larger, smaller);
            Vector128<float> denominator = Vector128.ConditionalSelect(steep, smaller + larger, larger);
            Vector128<float> numeratorError = steep & (smaller - (numerator + larger));
            Vector128<float> denominatorError = steep & (smaller - (denominator - larger));
            Vector128<float> turns = AddAtan(start, nearX ^ behind ^ left, steep, numerator, denominator, numeratorError, denominatorError);
            Vector128.Store(Vector128.MinNative(turns, Vector128.Create(0.99999994f)), u + i);

            Vector128<float> large = larger * larger, small = smaller * smaller, square = large + small;
            Vector128<float> rest = (small - (square - large)) + (Vector128.FusedMultiplyAdd(larger, larger, -large) + Vector128.FusedMultiplyAdd(smaller, smaller, -small));
            Vector128<float> radius = Vector128.Sqrt(square);
            Vector128<float> error = (Vector128.FusedMultiplyAdd(-radius, radius, square) + rest) / (radius + radius);
            Vector128<float> low = Vector128.LessThanOrEqual(ay, radius), north = Vector128.LessThan(Vector128<float>.Zero, py);
            start = Vector128.ConditionalSelect(low, Vector128.Create(0.25f), north & Vector128.Create(0.5f));
            (smaller, larger) = (Vector128.MinNative(ay, radius), Vector128.MaxNative(ay, radius));
            steep = Vector128.LessThan(larger * Vector128.Create(0.41421356237309503f), smaller);
            numerator = Vector128.ConditionalSelect(steep, smaller - larger, smaller);
            denominator = Vector128.ConditionalSelect(steep, smaller + larger, larger);
            numeratorError = (steep & (smaller - (numerator + larger))) + Vector128.ConditionalSelect(low, -(steep & error), error);
            denominatorError = (steep & (smaller - (denominator - larger))) + ((low | steep) & error);
            turns = AddAtan(start, north ^ low, steep, numerator, denominator, numeratorError, denominatorError);
            Vector128.Store(turns + turns, v + i);
        }

        return true;
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Vector128<float> AddAtan(Vector128<float> start, Vector128<float> minus, Vector128<float> steep, Vector128<float> numerator, Vector128<float> denominator, Vector128<float> numeratorError, Vector128<float> denominatorError)
    {
        Vector128<float> inverse = Vector128<float>.One / denominator, q = numerator * inverse;
        Vector128<float> residual = Vector128.FusedMultiplyAdd(-q, denominator, numerator) + numeratorError;
        Vector128<float> qError = Vector128.FusedMultiplyAdd(-q, denominatorError, residual) * inverse;

        Vector128<float> s = q * q, s2 = s * s;
        Vector128<float> even = Vector128.FusedMultiplyAdd(Vector128.Create(-0.009673409163951874f), s2, Vector128.Create(-0.022669268772006035f));
        even = Vector128.FusedMultiplyAdd(even, s2, Vector128.Create(-0.05305161699652672f));
        Vector128<float> odd = Vector128.FusedMultiplyAdd(Vector128.Create(0.016860434785485268f), s2, Vector128.Create(0.03182855620980263f));
        Vector128<float> tail = Vector128.FusedMultiplyAdd(s, Vector128.FusedMultiplyAdd(odd, s, even), Vector128.Create(6.4206382432985265e-09f));
        Vector128<float> sign = minus & Vector128.Create(-0.0f), leading = Vector128.Create(0.15915494309189535f);
        Vector128<float> origin = start + ((steep & Vector128.Create(0.125f)) ^ sign);
        q ^= sign;
        Vector128<float> product = q * leading, sum = origin + product;
        Vector128<float> rest = Vector128.FusedMultiplyAdd(q, leading, -product) + (product - (sum - origin));
        return sum + Vector128.FusedMultiplyAdd(qError ^ sign, leading, Vector128.FusedMultiplyAdd(q, tail, rest));
    }
}
