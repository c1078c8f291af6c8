using System.Runtime.CompilerServices;
using System.Runtime.Intrinsics;

namespace LabRaytracer.Benchmarks;

/// <summary>The spherical mapping written by hand for 512-bit registers of float: what the generic form is measured against.</summary>
internal static unsafe class HandWrittenSingle512
{
    /// <summary>Maps points whose magnitudes are ordinary; false as soon as a group is not.</summary>
    public static bool Map(float* x, float* y, float* z, float* u, float* v, int count)
    {
        for (int i = 0; i < count; i += Vector512<float>.Count)
        {
            Vector512<float> px = Vector512.Load(x + i), py = Vector512.Load(y + i), pz = Vector512.Load(z + i);
            Vector512<float> ax = Vector512.Abs(px), ay = Vector512.Abs(py), az = Vector512.Abs(pz), sum = ax + az;
            if (!Vector512.LessThanOrEqualAll(Vector512.Create(1.8189894035458565e-12f), sum) || !Vector512.LessThanAll(sum + ay, Vector512.Create(1152921504606846976f)))
            {
                return false;
            }

            Vector512<float> larger = Vector512.MaxNative(ax, az), smaller = Vector512.MinNative(ax, az);
            Vector512<float> nearX = Vector512.LessThan(az, ax), behind = Vector512.LessThan(pz, Vector512<float>.Zero), left = Vector512.LessThan(px, Vector512<float>.Zero);
            Vector512<float> start = Vector512.ConditionalSelect(nearX, Vector512.Create(0.25f), behind & Vector512.Create(0.5f));
            start = Vector512.ConditionalSelect(left, Vector512<float>.One - start, start);
            Vector512<float> steep = Vector512.LessThan(larger * Vector512.Create(0.41421356237309503f), smaller);
            Vector512<float> numerator = Vector512.ConditionalSelect(steep, smaller - larger, smaller);
            Vector512<float> denominator = Vector512.ConditionalSelect(steep, smaller + larger, larger);
            Vector512<float> numeratorError = steep & (smaller - (numerator + larger));
            Vector512<float> denominatorError = steep & (smaller - (denominator - larger));
            Vector512<float> turns = AddAtan(start, nearX ^ behind ^ left, steep, numerator, denominator, numeratorError, denominatorError);
            Vector512.Store(Vector512.MinNative(turns, Vector512.Create(0.99999994f)), u + i);

            Vector512<float> large = larger * larger, small = smaller * smaller, square = large + small;
            Vector512<float> rest = (small - (square - large)) + (Vector512.FusedMultiplyAdd(larger, larger, -large) + Vector512.FusedMultiplyAdd(smaller, smaller, -small));
            Vector512<float> radius = Vector512.Sqrt(square);
            Vector512<float> error = (Vector512.FusedMultiplyAdd(-radius, radius, square) + rest) / (radius + radius);
            Vector512<float> low = Vector512.LessThanOrEqual(ay, radius), north = Vector512.LessThan(Vector512<float>.Zero, py);
            start = Vector512.ConditionalSelect(low, Vector512.Create(0.25f), north & Vector512.Create(0.5f));
            (smaller, larger) = (Vector512.MinNative(ay, radius), Vector512.MaxNative(ay, radius));
            steep = Vector512.LessThan(larger * Vector512.Create(0.41421356237309503f), smaller);
            numerator = Vector512.ConditionalSelect(steep, smaller - larger, smaller);
            denominator = Vector512.ConditionalSelect(steep, smaller + larger, larger);
            numeratorError = (steep & (smaller - (numerator + larger))) + Vector512.ConditionalSelect(low, -(steep & error), error);
            denominatorError = (steep & (smaller - (denominator - larger))) + ((low | steep) & error);
            turns = AddAtan(start, north ^ low, steep, numerator, denominator, numeratorError, denominatorError);
            Vector512.Store(turns + turns, v + i);
        }

        return true;
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Vector512<float> AddAtan(Vector512<float> start, Vector512<float> minus, Vector512<float> steep, Vector512<float> numerator, Vector512<float> denominator, Vector512<float> numeratorError, Vector512<float> denominatorError)
    {
        Vector512<float> inverse = Vector512<float>.One / denominator, q = numerator * inverse;
        Vector512<float> residual = Vector512.FusedMultiplyAdd(-q, denominator, numerator) + numeratorError;
        Vector512<float> qError = Vector512.FusedMultiplyAdd(-q, denominatorError, residual) * inverse;

        Vector512<float> s = q * q, s2 = s * s;
        Vector512<float> even = Vector512.FusedMultiplyAdd(Vector512.Create(-0.009673409163951874f), s2, Vector512.Create(-0.022669268772006035f));
        even = Vector512.FusedMultiplyAdd(even, s2, Vector512.Create(-0.05305161699652672f));
        Vector512<float> odd = Vector512.FusedMultiplyAdd(Vector512.Create(0.016860434785485268f), s2, Vector512.Create(0.03182855620980263f));
        Vector512<float> tail = Vector512.FusedMultiplyAdd(s, Vector512.FusedMultiplyAdd(odd, s, even), Vector512.Create(6.4206382432985265e-09f));
        Vector512<float> sign = minus & Vector512.Create(-0.0f), leading = Vector512.Create(0.15915494309189535f);
        Vector512<float> origin = start + ((steep & Vector512.Create(0.125f)) ^ sign);
        q ^= sign;
        Vector512<float> product = q * leading, sum = origin + product;
        Vector512<float> rest = Vector512.FusedMultiplyAdd(q, leading, -product) + (product - (sum - origin));
        return sum + Vector512.FusedMultiplyAdd(qError ^ sign, leading, Vector512.FusedMultiplyAdd(q, tail, rest));
    }
}
