using System.Runtime.CompilerServices;
using System.Runtime.Intrinsics;

namespace LabRaytracer.Benchmarks;

/// <summary>The spherical mapping written by hand for 512-bit registers of double: what the generic form is measured against.</summary>
internal static unsafe class HandWrittenDouble512
{
    /// <summary>Maps points whose magnitudes are ordinary; false as soon as a group is not.</summary>
    public static bool Map(double* x, double* y, double* z, double* u, double* v, int count)
    {
        for (int i = 0; i < count; i += Vector512<double>.Count)
        {
            Vector512<double> px = Vector512.Load(x + i), py = Vector512.Load(y + i), pz = Vector512.Load(z + i);
            Vector512<double> ax = Vector512.Abs(px), ay = Vector512.Abs(py), az = Vector512.Abs(pz), sum = ax + az;
            if (!Vector512.LessThanOrEqualAll(Vector512.Create(1.2446030555722283e-60), sum) || !Vector512.LessThanAll(sum + ay, Vector512.Create(2.5822498780869086e120)))
            {
                return false;
            }

            Vector512<double> larger = Vector512.MaxNative(ax, az), smaller = Vector512.MinNative(ax, az);
            Vector512<double> nearX = Vector512.LessThan(az, ax), behind = Vector512.LessThan(pz, Vector512<double>.Zero), left = Vector512.LessThan(px, Vector512<double>.Zero);
            Vector512<double> start = Vector512.ConditionalSelect(nearX, Vector512.Create(0.25), behind & Vector512.Create(0.5));
            start = Vector512.ConditionalSelect(left, Vector512<double>.One - start, start);
            Vector512<double> steep = Vector512.LessThan(larger * Vector512.Create(0.41421356237309503), smaller);
            Vector512<double> numerator = Vector512.ConditionalSelect(steep, smaller - larger, smaller);
            Vector512<double> denominator = Vector512.ConditionalSelect(steep, smaller + larger, larger);
            Vector512<double> numeratorError = steep & (smaller - (numerator + larger));
            Vector512<double> denominatorError = steep & (smaller - (denominator - larger));
            Vector512<double> turns = AddAtan(start, nearX ^ behind ^ left, steep, numerator, denominator, numeratorError, denominatorError);
            Vector512.Store(Vector512.MinNative(turns, Vector512.Create(0.99999999999999989)), u + i);

            Vector512<double> large = larger * larger, small = smaller * smaller, square = large + small;
            Vector512<double> rest = (small - (square - large)) + (Vector512.FusedMultiplyAdd(larger, larger, -large) + Vector512.FusedMultiplyAdd(smaller, smaller, -small));
            Vector512<double> radius = Vector512.Sqrt(square);
            Vector512<double> error = (Vector512.FusedMultiplyAdd(-radius, radius, square) + rest) / (radius + radius);
            Vector512<double> low = Vector512.LessThanOrEqual(ay, radius), north = Vector512.LessThan(Vector512<double>.Zero, py);
            start = Vector512.ConditionalSelect(low, Vector512.Create(0.25), north & Vector512.Create(0.5));
            (smaller, larger) = (Vector512.MinNative(ay, radius), Vector512.MaxNative(ay, radius));
            steep = Vector512.LessThan(larger * Vector512.Create(0.41421356237309503), smaller);
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
    private static Vector512<double> AddAtan(Vector512<double> start, Vector512<double> minus, Vector512<double> steep, Vector512<double> numerator, Vector512<double> denominator, Vector512<double> numeratorError, Vector512<double> denominatorError)
    {
        Vector512<double> inverse = Vector512<double>.One / denominator, q = numerator * inverse;
        Vector512<double> residual = Vector512.FusedMultiplyAdd(-q, denominator, numerator) + numeratorError;
        Vector512<double> qError = Vector512.FusedMultiplyAdd(-q, denominatorError, residual) * inverse;

        Vector512<double> s = q * q, s2 = s * s;
        Vector512<double> even = Vector512.FusedMultiplyAdd(Vector512.Create(-0.00284943750816623), s2, Vector512.Create(-0.008020038465714181));
        even = Vector512.FusedMultiplyAdd(even, s2, Vector512.Create(-0.010604649356410235));
        even = Vector512.FusedMultiplyAdd(even, s2, Vector512.Create(-0.014468613090040723));
        even = Vector512.FusedMultiplyAdd(even, s2, Vector512.Create(-0.02273642043286274));
        even = Vector512.FusedMultiplyAdd(even, s2, Vector512.Create(-0.053051647697298226));
        Vector512<double> odd = Vector512.FusedMultiplyAdd(Vector512.Create(0.006057564491080749), s2, Vector512.Create(0.009307139268913885));
        odd = Vector512.FusedMultiplyAdd(odd, s2, Vector512.Create(0.012242293061496124));
        odd = Vector512.FusedMultiplyAdd(odd, s2, Vector512.Create(0.017683882041843634));
        odd = Vector512.FusedMultiplyAdd(odd, s2, Vector512.Create(0.03183098861830459));
        Vector512<double> tail = Vector512.FusedMultiplyAdd(s, Vector512.FusedMultiplyAdd(odd, s, even), Vector512.Create(-9.839338337591243e-18));
        Vector512<double> sign = minus & Vector512.Create(-0.0), leading = Vector512.Create(0.15915494309189535);
        Vector512<double> origin = start + ((steep & Vector512.Create(0.125)) ^ sign);
        q ^= sign;
        Vector512<double> product = q * leading, sum = origin + product;
        Vector512<double> rest = Vector512.FusedMultiplyAdd(q, leading, -product) + (product - (sum - origin));
        return sum + Vector512.FusedMultiplyAdd(qError ^ sign, leading, Vector512.FusedMultiplyAdd(q, tail, rest));
    }
}
