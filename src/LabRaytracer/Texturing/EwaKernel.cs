using System.Runtime.CompilerServices;

namespace LabRaytracer;

/// <summary>The weights of texels around a place, one lookup: how much of each texel lies inside the parallelogram of its footprint.</summary>
/// <remarks>
/// <para>With s and t the coordinates of the footprint, in which it is the square from -1/2 to 1/2, a texel stretches over e_s = |grad s| and e_t = |grad t|, so that the shares of it
/// between the sides are trapezoids of s and of t; the weight is their product. Where the sides are at right angles and lie along the texels' axes, that is the exact share.
/// Where they are nearly parallel, both trapezoids cut the same texels, and the product is corrected by their correlation (Hoeffding's bounds of a joint probability).</para>
/// <para>Footprints narrower than a texel are widened to one, at right angles to their longer axis, where the weights become those of linear interpolation.</para>
/// </remarks>
/// <param name="numbers">What <see cref="Store"/> wrote, at the lane of the lookup.</param>
/// <param name="width">Lanes of the group.</param>
internal readonly unsafe struct EwaKernel(float* numbers, int width)
{
    /// <summary>How many groups of numbers <see cref="Store"/> writes for a group of lookups.</summary>
    public const int Numbers = 15;

    /// <summary>Number of the group: s of a step along a row, in units in which its trapezoid falls by 1 over 1.</summary>
    public const int SXNumber = 0;

    /// <summary>s of a step across the rows.</summary>
    public const int SYNumber = 1;

    /// <summary>t of a step along a row, in units in which its trapezoid falls by 1 over 1.</summary>
    public const int TXNumber = 3;

    /// <summary>t of a step across the rows.</summary>
    public const int TYNumber = 4;

    /// <summary>Half the extent along rows, texels.</summary>
    public const int ReachXNumber = 7;

    /// <summary>Half the extent across the rows, texels.</summary>
    public const int ReachYNumber = 8;

    /// <summary>Where pairs of rows cross the strip of s: its middle moves by this much a row.</summary>
    public const int SlantSNumber = 9;

    /// <summary>Texels of a pair of rows within this reach of that middle can lie inside the strip.</summary>
    public const int ReachSNumber = 10;

    /// <summary>Centre along a row, texels, from the centre of the texel to the left, [0, 1).</summary>
    public const int CenterXNumber = 11;

    /// <summary>Centre across the rows, texels, from the centre of the texel below, [0, 1).</summary>
    public const int CenterYNumber = 12;

    /// <summary>The slant of the strip of t.</summary>
    public const int SlantTNumber = 13;

    /// <summary>Its reach.</summary>
    public const int ReachTNumber = 14;

    /// <summary>Components of grad s below this one, in 1/texels, do not bound a row: the other sides do.</summary>
    private const double LeastGradient = 1.0 / 4096;

    /// <summary>Stands for no bound, texels.</summary>
    private const double Far = 1e6;

    /// <summary>s of a step along a row.</summary>
    public float SX => numbers[SXNumber];

    /// <summary>s of a step across the rows.</summary>
    public float SY => numbers[SYNumber * width];

    /// <summary>Where the trapezoid of s reaches 0.</summary>
    public float SEnd => numbers[2 * width];

    /// <summary>t of a step along a row.</summary>
    public float TX => numbers[TXNumber * width];

    /// <summary>t of a step across the rows.</summary>
    public float TY => numbers[TYNumber * width];

    /// <summary>Where the trapezoid of t reaches 0.</summary>
    public float TEnd => numbers[5 * width];

    /// <summary>0 where the sides are at right angles, up to 1 or -1 where they are parallel.</summary>
    public float Skew => numbers[6 * width];

    /// <summary>Writes the numbers of a group of lookups.</summary>
    /// <param name="ax">First side of the footprint along rows, texels of the level.</param>
    /// <param name="ay">First side across.</param>
    /// <param name="bx">Second side along rows.</param>
    /// <param name="by">Second side across.</param>
    /// <param name="centerX">Centre along a row, texels, from the centre of the texel to the left, [0, 1).</param>
    /// <param name="centerY">Centre across the rows, texels, from the centre of the texel below, [0, 1).</param>
    /// <param name="numbers">Receives <see cref="Numbers"/> groups of lanes.</param>
    [MethodImpl(MethodImplOptions.NoInlining)]
    public static void Store<F>(F ax, F ay, F bx, F by, F centerX, F centerY, F* numbers)
        where F : unmanaged, IReal<F>
    {
        F one = F.Of(1), half = F.Of(0.5);
        F area = Widen(ref ax, ref ay, ref bx, ref by);
        F inverse = one / area;
        F sx = by * inverse, sy = -bx * inverse, tx = -ay * inverse, ty = ax * inverse;
        F es = F.Sqrt(F.Fma(sx, sx, sy * sy)), et = F.Sqrt(F.Fma(tx, tx, ty * ty));
        F cosine = F.Fma(sx, tx, sy * ty) / (es * et), excess = F.Max(F.Fma(F.Abs(cosine), F.Of(2), -one), F.Zero);
        F endS = F.Fma(es, half, half), endT = F.Fma(et, half, half);
        F slopeS = one / F.Min(es, one), slopeT = one / F.Min(et, one);
        numbers[SXNumber] = sx * slopeS;
        numbers[SYNumber] = sy * slopeS;
        numbers[2] = endS * slopeS;
        numbers[TXNumber] = tx * slopeT;
        numbers[TYNumber] = ty * slopeT;
        numbers[5] = endT * slopeT;
        numbers[6] = F.Min(excess, one) * F.Select(F.Less(cosine, F.Zero), -one, one);
        numbers[ReachXNumber] = F.Fma(endS, F.Abs(ax), endT * F.Abs(bx));
        numbers[ReachYNumber] = F.Fma(endS, F.Abs(ay), endT * F.Abs(by));
        (numbers[SlantSNumber], numbers[ReachSNumber]) = Bound(sx, sy, endS);
        (numbers[SlantTNumber], numbers[ReachTNumber]) = Bound(tx, ty, endT);
        numbers[CenterXNumber] = centerX;
        numbers[CenterYNumber] = centerY;
    }

    /// <summary>Where a strip between two sides crosses rows: its middle moves by the slant a row; half its width, and what it moves over half a row.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static (F Slant, F Reach) Bound<F>(F x, F y, F end)
        where F : unmanaged, IReal<F>
    {
        F isFlat = F.Less(F.Abs(x), F.Of(LeastGradient)), inverse = F.Of(1) / F.Select(isFlat, F.Of(1), x), slant = -y * inverse;
        return (~isFlat & slant, F.Select(isFlat, F.Of(Far), F.Fma(F.Abs(slant), F.Of(0.5), end * F.Abs(inverse))));
    }

    /// <summary>Widens parallelograms to a texel at right angles to their longer axis: the smaller singular value of their sides becomes at least 1.</summary>
    /// <returns>The area, signed.</returns>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static F Widen<F>(ref F ax, ref F ay, ref F bx, ref F by)
        where F : unmanaged, IReal<F>
    {
        F square = LongerSquare(ax, ay, bx, by), longer = F.Sqrt(square), shorter = F.Fma(ax, by, -(ay * bx)) / longer;
        F least = F.Max(F.Abs(shorter), F.Of(1)), wide = F.Select(F.Less(shorter, F.Zero), -least, least);
        F more = (wide - shorter) / F.Max(F.Fma(-shorter, shorter, square), F.Of(1e-6));

        // u2 v2' = (s1 cof(J) - s2 J) / (s1^2 - s2^2), for the sides J = s1 u1 v1' + s2 u2 v2' in columns.
        F along = F.Fma(-more, shorter, F.Of(1)), across = more * longer;
        (ax, ay, bx, by) = (F.Fma(across, by, along * ax), F.Fma(-across, bx, along * ay), F.Fma(-across, ay, along * bx), F.Fma(across, ax, along * by));
        return F.Fma(ax, by, -(ay * bx));
    }

    /// <summary>The square of the longer axis of parallelograms: of the ellipse around all points whose mean square distances are 12 times those of the parallelogram.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static F LongerSquare<F>(F ax, F ay, F bx, F by)
        where F : unmanaged, IReal<F>
    {
        F xx = F.Fma(ax, ax, bx * bx), xy = F.Fma(ax, ay, bx * by), yy = F.Fma(ay, ay, by * by), half = (xx - yy) * F.Of(0.5);
        return F.Fma(xx + yy, F.Of(0.5), F.Sqrt(F.Fma(half, half, xy * xy)));
    }
}
