using System.Runtime.CompilerServices;
using System.Runtime.Intrinsics;

namespace LabRaytracer.Benchmarks;

/// <summary>The spherical mapping written by hand for 256-bit registers of double: what the generic form is measured against.</summary>
internal static unsafe class HandWrittenDouble256
{
    /// <summary>Maps points whose magnitudes are ordinary; false as soon as a group is not.</summary>
    public static bool Map(double* x, double* y, double* z, double* u, double* v, int count)
    {
        for (int i = 0; i < count; i += Vector256<double>.Count)
        {
            Vector256<double> px = Vector256.Load(x + i), py = Vector256.Load(y + i), pz = Vector256.Load(z + i);
            Vector256<double> ax = Vector256.Abs(px), ay = Vector256.Abs(py), az = Vector256.Abs(pz), sum = ax + az;
            if (!Vector256.LessThanOrEqualAll(Vector256.Create(1.2446030555722283e-60), sum) || !Vector256.LessThanAll(sum + ay, Vector256.Create(2.5822498780869086e120)))
            {
                return false;
            }

            Vector256<double> larger = Vector256.MaxNative(ax, az), smaller = Vector256.MinNative(ax, az);
            Vector256<double> nearX = Vector256.LessThan(az, ax), behind = Vector256.LessThan(pz, Vector256<double>.Zero), left = Vector256.LessThan(px, Vector256<double>.Zero);
            Vector256<double> start = Vector256.ConditionalSelect(nearX, Vector256.Create(0.25), behind & Vector256.Create(0.5));
            start = Vector256.ConditionalSelect(left, Vector256<double>.One - start, start);
            Vector256<double> steep = Vector256.LessThan(larger * Vector256.Create(0.41421356237309503), smaller);
            Vector256<double> numerator = Vector256.ConditionalSelect(steep, smaller - larger, smaller);
            Vector256<double> denominator = Vector256.ConditionalSelect(steep, smaller + larger, larger);
            Vector256<double> numeratorError = steep & (smaller - (numerator + larger));
            Vector256<double> denominatorError = steep & (smaller - (denominator - larger));
            Vector256<double> turns = AddAtan(start, nearX ^ behind ^ left, steep, numerator, denominator, numeratorError, denominatorError);
            Vector256.Store(Vector256.MinNative(turns, Vector256.Create(0.99999999999999989)), u + i);

            Vector256<double> large = larger * larger, small = smaller * smaller, square = large + small;
            Vector256<double> rest = (small - (square - large)) + (Vector256.FusedMultiplyAdd(larger, larger, -large) + Vector256.FusedMultiplyAdd(smaller, smaller, -small));
            Vector256<double> radius = Vector256.Sqrt(square);
            Vector256<double> error = (Vector256.FusedMultiplyAdd(-radius, radius, square) + rest) / (radius + radius);
            Vector256<double> low = Vector256.LessThanOrEqual(ay, radius), north = Vector256.LessThan(Vector256<double>.Zero, py);
            start = Vector256.ConditionalSelect(low, Vector256.Create(0.25), north & Vector256.Create(0.5));
            (smaller, larger) = (Vector256.MinNative(ay, radius), Vector256.MaxNative(ay, radius));
            steep = Vector256.LessThan(larger * Vector256.Create(0.41421356237309503), smaller);
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
    private static Vector256<double> AddAtan(Vector256<double> start, Vector256<double> minus, Vector256<double> steep, Vector256<double> numerator, Vector256<double> denominator, Vector256<double> numeratorError, Vector256<double> denominatorError)
    {
        Vector256<double> inverse = Vector256<double>.One / denominator, q = numerator * inverse;
        Vector256<double> residual = Vector256.FusedMultiplyAdd(-q, denominator, numerator) + numeratorError;
        Vector256<double> qError = Vector256.FusedMultiplyAdd(-q, denominatorError, residual) * inverse;

        Vector256<double> s = q * q, s2 = s * s;
        Vector256<double> even = Vector256.FusedMultiplyAdd(Vector256.Create(-0.00284943750816623), s2, Vector256.Create(-0.008020038465714181));
        even = Vector256.FusedMultiplyAdd(even, s2, Vector256.Create(-0.010604649356410235));
        even = Vector256.FusedMultiplyAdd(even, s2, Vector256.Create(-0.014468613090040723));
        even = Vector256.FusedMultiplyAdd(even, s2, Vector256.Create(-0.02273642043286274));
        even = Vector256.FusedMultiplyAdd(even, s2, Vector256.Create(-0.053051647697298226));
        Vector256<double> odd = Vector256.FusedMultiplyAdd(Vector256.Create(0.006057564491080749), s2, Vector256.Create(0.009307139268913885));
        odd = Vector256.FusedMultiplyAdd(odd, s2, Vector256.Create(0.012242293061496124));
        odd = Vector256.FusedMultiplyAdd(odd, s2, Vector256.Create(0.017683882041843634));
        odd = Vector256.FusedMultiplyAdd(odd, s2, Vector256.Create(0.03183098861830459));
        Vector256<double> tail = Vector256.FusedMultiplyAdd(s, Vector256.FusedMultiplyAdd(odd, s, even), Vector256.Create(-9.839338337591243e-18));
        Vector256<double> sign = minus & Vector256.Create(-0.0), leading = Vector256.Create(0.15915494309189535);
        Vector256<double> origin = start + ((steep & Vector256.Create(0.125)) ^ sign);
        q ^= sign;
        Vector256<double> product = q * leading, sum = origin + product;
        Vector256<double> rest = Vector256.FusedMultiplyAdd(q, leading, -product) + (product - (sum - origin));
        return sum + Vector256.FusedMultiplyAdd(qError ^ sign, leading, Vector256.FusedMultiplyAdd(q, tail, rest));
    }
}
