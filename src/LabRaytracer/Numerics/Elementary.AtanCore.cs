using System.Runtime.CompilerServices;

namespace LabRaytracer;

/// <content>The arctangent itself: every rounding before the last one is carried along in a second, small part.</content>
internal static partial class Elementary
{
    /// <summary>
    /// Reduces smaller / larger, [0, 1], to a quotient of at most tan(pi/8): above, atan(q) = pi/4 + atan((q - 1) / (q + 1)).
    /// </summary>
    /// <returns>Mask: reduced.</returns>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static T Reduce<T>(T smaller, T larger, out T numerator, out T denominator, out T numeratorError, out T denominatorError)
        where T : unmanaged, IReal<T>
    {
        T steep = T.Less(larger * T.Of(0.41421356237309503), smaller);
        numerator = T.Select(steep, smaller - larger, smaller);
        denominator = T.Select(steep, smaller + larger, larger);
        numeratorError = steep & (smaller - (numerator + larger));
        denominatorError = steep & (smaller - (denominator - larger));
        return steep;
    }

    /// <summary>Adds the error of the radius, which is the larger operand where the mask says so, to the errors of a reduced quotient.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void Correct<T>(T steep, T radiusIsLarger, T radiusError, ref T numeratorError, ref T denominatorError)
        where T : unmanaged, IReal<T>
    {
        numeratorError += T.Select(radiusIsLarger, -(steep & radiusError), radiusError);
        denominatorError += (radiusIsLarger | steep) & radiusError;
    }

    /// <summary>start + atan(smaller / larger) / 2 pi of a reduced quotient, or minus where the mask says so.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static T AddAtanTurns<T>(T start, T minus, T steep, T numerator, T denominator, T numeratorError, T denominatorError)
        where T : unmanaged, IReal<T>
    {
        T inverse = T.Of(1) / denominator;
        T q = numerator * inverse;
        T qError = T.Fma(-q, denominatorError, T.Fma(-q, denominator, numerator) + numeratorError) * inverse;

        T s = q * q;
        T tail = T.IsSingle
            ? T.Fma(s, AtanTailSingle(s), T.Of(6.4206382432985265e-09))
            : T.Fma(s, AtanTailDouble(s), T.Of(-9.839338337591243e-18));
        T sign = minus & T.Of(-0.0);
        T leading = T.Of(0.15915494309189535);
        T origin = start + ((steep & T.Of(0.125)) ^ sign);
        q ^= sign;
        T product = q * leading;
        T sum = origin + product;
        T rest = T.Fma(q, leading, -product) + (product - (sum - origin));
        return sum + T.Fma(qError ^ sign, leading, T.Fma(q, tail, rest));
    }
}
