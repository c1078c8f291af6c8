using System.Numerics;

namespace LabRaytracer;

/// <summary>
/// A real number, or several side by side ("lanes"): the type a formula is written over, once, for any width and precision.
/// </summary>
/// <typeparam name="T">The implementing lane type.</typeparam>
/// <remarks>
/// Every operation is correctly rounded lane by lane, so that a formula gives the same bits at every width and on every machine.
/// A mask is a <typeparamref name="T"/> whose lanes are all ones (true) or all zeros (false).
/// </remarks>
internal interface IReal<T> :
    IAdditionOperators<T, T, T>, ISubtractionOperators<T, T, T>, IMultiplyOperators<T, T, T>, IDivisionOperators<T, T, T>,
    IUnaryNegationOperators<T, T>, IBitwiseOperators<T, T, T>
    where T : unmanaged, IReal<T>
{
    /// <summary>Number of lanes: 1, 2, 4, 8 or 16.</summary>
    static abstract int Width { get; }

    /// <summary>True for float lanes (24-bit significand), false for double lanes (53-bit): a constant for the compiler.</summary>
    static abstract bool IsSingle { get; }

    /// <summary>Zero in every lane; also the mask "false everywhere".</summary>
    static abstract T Zero { get; }

    /// <summary>The mask "true everywhere".</summary>
    static abstract T True { get; }

    /// <summary>The same number in every lane, rounded to the lane's precision.</summary>
    static abstract T Of(double value);

    /// <summary>The numbers <c>start, start + 1, start + 2, ...</c>, one a lane.</summary>
    static abstract T Iota(double start);

    /// <summary>Absolute value.</summary>
    static abstract T Abs(T a);

    /// <summary><c>a &lt; b ? a : b</c>; the second operand where either is NaN.</summary>
    static abstract T Min(T a, T b);

    /// <summary><c>a &gt; b ? a : b</c>; the second operand where either is NaN.</summary>
    static abstract T Max(T a, T b);

    /// <summary>Correctly rounded square root; NaN below zero.</summary>
    static abstract T Sqrt(T a);

    /// <summary>Largest integer not above the number.</summary>
    static abstract T Floor(T a);

    /// <summary><c>a * b + c</c> with one rounding.</summary>
    static abstract T Fma(T a, T b, T c);

    /// <summary>Exponent of a positive, normal number, as a number: floor(log2(a)), exactly.</summary>
    static abstract T Exponent(T a);

    /// <summary>The power of two <c>2^n</c>, exactly; n is an integer, [-1022, 1023] in double lanes, [-126, 127] in float lanes.</summary>
    static abstract T PowerOfTwo(T n);

    /// <summary>Mask of <c>a &lt; b</c>; false where either is NaN.</summary>
    static abstract T Less(T a, T b);

    /// <summary>Mask of <c>a &lt;= b</c>; false where either is NaN.</summary>
    static abstract T LessOrEqual(T a, T b);

    /// <summary>Mask of <c>a == b</c>; false where either is NaN.</summary>
    static abstract T Equal(T a, T b);

    /// <summary>Lane by lane, <paramref name="yes"/> where the mask is true, else <paramref name="no"/>.</summary>
    static abstract T Select(T mask, T yes, T no);

    /// <summary>Bit i is set where lane i of the mask is true.</summary>
    static abstract uint Bits(T mask);

    /// <summary>Tells whether a mask is true in any lane.</summary>
    static abstract bool Any(T mask);

    /// <summary>Tells whether a mask is true in every lane.</summary>
    static abstract bool All(T mask);

    /// <summary>The largest number of all lanes, none of which is NaN.</summary>
    static abstract double Largest(T a);

    /// <summary>The number in one lane, exactly.</summary>
    /// <param name="a">The lanes.</param>
    /// <param name="lane">Lane, [0, <see cref="Width"/>).</param>
    static abstract double Get(T a, int lane);
}
