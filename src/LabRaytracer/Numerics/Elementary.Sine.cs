using System.Runtime.CompilerServices;

namespace LabRaytracer;

/// <content>Sine and cosine.</content>
internal static partial class Elementary
{
    /// <summary>Sine and cosine of an angle in degrees; exact at multiples of 90 degrees.</summary>
    /// <param name="degrees">Angle, finite, any size.</param>
    /// <remarks>Error at most 1.5 ulp (ElementaryOracleTests: 0.83).</remarks>
    public static (double Sin, double Cos) SinCosDegrees(double degrees)
    {
        // Both steps are exact: the remainder by definition, the difference because it is a small multiple of its operands' last place.
        double angle = degrees % 360;
        double quarter = Math.Floor((angle / 90) + 0.5);
        angle -= 90 * quarter;
        double turns = angle / 360;
        double error = Math.FusedMultiplyAdd(-turns, 360, angle) / 360;
        (Double1 sin, Double1 cos) = SinCosQuarter(new Double1(quarter), new Double1(turns), new Double1(error));
        return (sin.Value, cos.Value);
    }

    /// <summary>Tangent of an angle in degrees; infinite at 90 degrees, 1 at 45.</summary>
    /// <param name="degrees">Angle, finite.</param>
    /// <remarks>Error at most 3 ulp (ElementaryOracleTests: 1.97).</remarks>
    public static double TanDegrees(double degrees)
    {
        if (Math.Abs(degrees) == 45)
        {
            return Math.Sign(degrees);
        }

        (double sin, double cos) = SinCosDegrees(degrees);
        return sin / cos;
    }

    /// <summary>Sine and cosine of an angle in turns; exact at multiples of a quarter turn.</summary>
    /// <param name="turns">Angle, finite, any size.</param>
    /// <remarks>Error at most 1.5 ulp in either precision (ElementaryOracleTests: 0.65).</remarks>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static (T Sin, T Cos) SinCosTurns<T>(T turns)
        where T : unmanaged, IReal<T>
    {
        T angle = T.Select(T.Less(T.Abs(turns), T.Of(1)), turns, turns - T.Floor(turns));
        T quarter = T.Floor(T.Fma(T.Of(4), angle, T.Of(0.5)));
        return SinCosQuarter(quarter, T.Fma(quarter, T.Of(-0.25), angle), T.Zero);
    }

    /// <summary>Sine and cosine of <c>quarter / 4 + angle + error</c> turns, angle in [-1/8, 1/8].</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static (T Sin, T Cos) SinCosQuarter<T>(T quarter, T angle, T error)
        where T : unmanaged, IReal<T>
    {
        T s = angle * angle;
        // The leading product is kept with its rounding error, so that the sine is rounded about once.
        T leading = T.Of(Math.Tau);
        T high = angle * leading;
        T tail = T.Fma(s, T.IsSingle ? SinTailSingle(s) : SinTailDouble(s), T.Of(T.IsSingle ? -1.7484555314695172e-07 : 2.4492935982947064e-16));
        T low = T.Fma(angle, leading, -high) + (angle * tail);
        T sin = high + low;
        T cos = T.Fma(s, T.Fma(s, T.IsSingle ? CosTailSingle(s) : CosTailDouble(s), T.Of(-2 * Math.PI * Math.PI)), T.Of(1));
        T errorRadians = error * T.Of(Math.Tau);
        T sinHere = T.Fma(errorRadians, cos, sin);
        T cosHere = T.Fma(-errorRadians, sin, cos);

        quarter -= T.Of(4) * T.Floor(quarter * T.Of(0.25));
        T first = T.Equal(quarter, T.Of(1));
        T second = T.Equal(quarter, T.Of(2));
        T third = T.Equal(quarter, T.Of(3));
        T odd = first | third;
        T sign = T.Of(-0.0);
        return (
            T.Select(odd, cosHere, sinHere) ^ ((second | third) & sign),
            T.Select(odd, sinHere, cosHere) ^ ((first | second) & sign));
    }
}
