using System.Runtime.CompilerServices;

namespace LabRaytracer;

/// <summary>A sequence of points that fill the unit square evenly: the (0, 2)-sequence of Sobol's first two dimensions (Sobol 1967; Kollig and Keller 2002).</summary>
/// <remarks>
/// Of any 2^m consecutive points whose first number is a multiple of 2^m, exactly one lies in each cell of every grid of 2^a x 2^(m - a) cells.
/// Points are 32-bit fractions. Exclusive-or with any pair of numbers keeps the property ("scrambled" points) and, if the pair is random, makes each point uniform.
/// </remarks>
internal static class SquareSequence
{
    /// <summary>First coordinate of a point, in units of 2^-32: the digits of its number in base 2 mirrored at the point (van der Corput 1935).</summary>
    /// <param name="number">Number of the point.</param>
    public static uint First(uint number)
    {
        number = (number << 16) | (number >> 16);
        number = ((number & 0x00FF00FF) << 8) | ((number >> 8) & 0x00FF00FF);
        number = ((number & 0x0F0F0F0F) << 4) | ((number >> 4) & 0x0F0F0F0F);
        number = ((number & 0x33333333) << 2) | ((number >> 2) & 0x33333333);
        return ((number & 0x55555555) << 1) | ((number >> 1) & 0x55555555);
    }

    /// <summary>Second coordinate of a point, in units of 2^-32: the matrix of the primitive polynomial x + 1, Pascal's triangle modulo 2.</summary>
    /// <param name="number">Number of the point.</param>
    /// <remarks>
    /// With the digits of the first coordinate as coefficients of a polynomial p(z), the second one's are those of p(1 + z) modulo 2. As (1 + z)^s = 1 + z^s there for
    /// every power of two s, halves p = a + z^s b become (a + b) + z^s b, first of 32 digits, then of 16 and so on.
    /// </remarks>
    public static uint Second(uint number)
    {
        uint point = First(number);
        point ^= point << 16;
        point ^= (point & 0x00FF00FF) << 8;
        point ^= (point & 0x0F0F0F0F) << 4;
        point ^= (point & 0x33333333) << 2;
        return point ^ ((point & 0x55555555) << 1);
    }

    /// <summary>A 32-bit fraction as a number in (0, 1): the middle of its cell of width 2^-23, exact in both precisions.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static R Unit<R, F, I>(I fraction)
        where R : unmanaged, ILane<R, F, I>
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I> => R.Fma(R.FromInt32(I.ShiftRight(fraction, 9)), R.Of(1.0 / (1 << 23)), R.Of(0.5 / (1 << 23)));

    /// <summary>A 32-bit fraction as a number in (0, 1): the middle of its cell of width 2^-32.</summary>
    public static double Unit(uint fraction) => (fraction + 0.5) * (1.0 / (1UL << 32));
}
