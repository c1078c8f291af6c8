using System.Runtime.CompilerServices;

namespace LabRaytracer;

/// <summary>The sum of two numbers of a lane type that together have twice its digits.</summary>
/// <typeparam name="R">Lane type of geometry.</typeparam>
/// <remarks>
/// Relative error of each operation at most a few units of the square of the lane's precision, as long as nothing underflows:
/// Joldes, Muller, Popescu, "Tight and rigorous error bounds for basic building blocks of double-word arithmetic", ACM TOMS 44(2), 2017.
/// </remarks>
[SkipLocalsInit]
[method: MethodImpl(MethodImplOptions.AggressiveInlining)]
internal readonly struct DoubleWord<R>(R high, R low)
    where R : unmanaged, IReal<R>
{
    /// <summary>The number rounded to the lane's precision.</summary>
    public readonly R High = high;

    /// <summary>What is missing, at most half a unit in the last place of <see cref="High"/>.</summary>
    public readonly R Low = low;

    /// <summary>a - b, exactly.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static DoubleWord<R> Difference(R a, R b)
    {
        R difference = Compensated.Difference(a, b, out R error);
        return new DoubleWord<R>(difference, error);
    }

    /// <summary>a b, exactly.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static DoubleWord<R> Product(R a, R b)
    {
        R product = a * b;
        return new DoubleWord<R>(product, R.Fma(a, b, -product));
    }

    [MethodImpl(MethodImplOptions.NoInlining)]
    public static DoubleWord<R> operator +(in DoubleWord<R> a, in DoubleWord<R> b)
    {
        R high = Compensated.Difference(a.High, -b.High, out R highError);
        R low = Compensated.Difference(a.Low, -b.Low, out R lowError);
        DoubleWord<R> sum = Normalized(high, low + highError);
        return Normalized(sum.High, lowError + sum.Low);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static DoubleWord<R> operator -(in DoubleWord<R> a, in DoubleWord<R> b) => a + (-b);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static DoubleWord<R> operator -(in DoubleWord<R> a) => new(-a.High, -a.Low);

    [MethodImpl(MethodImplOptions.NoInlining)]
    public static DoubleWord<R> operator *(in DoubleWord<R> a, in DoubleWord<R> b)
    {
        DoubleWord<R> product = Product(a.High, b.High);
        return Normalized(product.High, product.Low + R.Fma(a.High, b.Low, a.Low * b.High));
    }

    [MethodImpl(MethodImplOptions.NoInlining)]
    public static DoubleWord<R> operator *(in DoubleWord<R> a, in R b)
    {
        DoubleWord<R> product = Product(a.High, b);
        return Normalized(product.High, R.Fma(a.Low, b, product.Low));
    }

    [MethodImpl(MethodImplOptions.NoInlining)]
    public static DoubleWord<R> operator /(in DoubleWord<R> a, in DoubleWord<R> b)
    {
        R quotient = a.High / b.High;
        R rest = R.Fma(-quotient, b.High, a.High) + R.Fma(-quotient, b.Low, a.Low);
        return Normalized(quotient, rest / b.High);
    }

    /// <summary>Square root; 0 for what is not above 0.</summary>
    [MethodImpl(MethodImplOptions.NoInlining)]
    public static DoubleWord<R> Sqrt(in DoubleWord<R> a)
    {
        R positive = R.Less(R.Zero, a.High);
        R root = R.Sqrt(positive & a.High);
        R rest = R.Fma(-root, root, a.High) + a.Low;
        return Normalized(root, positive & (rest / (root + root)));
    }

    /// <summary>Lane by lane, one or the other.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static DoubleWord<R> Select(in R mask, in DoubleWord<R> yes, in DoubleWord<R> no) =>
        new(R.Select(mask, yes.High, no.High), R.Select(mask, yes.Low, no.Low));

    /// <summary>A sum whose first part is the larger one.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static DoubleWord<R> Normalized(R high, R low)
    {
        R sum = high + low;
        return new DoubleWord<R>(sum, low - (sum - high));
    }
}
