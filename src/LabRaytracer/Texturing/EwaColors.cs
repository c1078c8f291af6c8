using System.Runtime.CompilerServices;

namespace LabRaytracer;

/// <summary>Weighted sums of texels that are red, green, blue, 1: the last one adds up the weights.</summary>
internal static class EwaColors
{
    /// <summary>Adds a block of texels, two in each register.</summary>
    /// <param name="weights">Weights of the lower row, then of the upper one.</param>
    /// <param name="lower0">Two texels of the lower row.</param>
    /// <param name="lower2">The next two.</param>
    /// <param name="upper0">Two texels of the upper row.</param>
    /// <param name="upper2">The next two.</param>
    /// <param name="even">The sum of the first two of each row.</param>
    /// <param name="odd">The sum of the next two.</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void Add(Float8 weights, Float8 lower0, Float8 lower2, Float8 upper0, Float8 upper2, ref Float8 even, ref Float8 odd)
    {
        even = Float8.Fma(Float8.Spread(weights, 0), lower0, even);
        odd = Float8.Fma(Float8.Spread(weights, 1), lower2, odd);
        even = Float8.Fma(Float8.Spread(weights, 2), upper0, even);
        odd = Float8.Fma(Float8.Spread(weights, 3), upper2, odd);
    }

    /// <summary>The sum of all texels.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Float4 Total(Float8 even, Float8 odd)
    {
        Float8 sums = even + odd;
        return Float8.Lower(sums) + Float8.Upper(sums);
    }
}
