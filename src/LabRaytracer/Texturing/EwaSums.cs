using System.Runtime.CompilerServices;

namespace LabRaytracer;

/// <summary>Sums over texels by their weights.</summary>
internal static unsafe class EwaSums
{
    /// <summary>The sum over some pairs of rows of one lookup: red, green, blue, and the sum of the weights.</summary>
    /// <typeparam name="TBlocks">Reads texels.</typeparam>
    /// <typeparam name="TWeights">How the shares of both strips go together.</typeparam>
    /// <typeparam name="F">Float lanes of the group.</typeparam>
    /// <param name="blocks">The texels.</param>
    /// <param name="kernel">What <see cref="EwaKernel.Store"/> wrote, at the lane of the lookup.</param>
    /// <param name="rows">What <see cref="EwaRows"/> wrote, at that lane.</param>
    /// <param name="first">Number of the first pair there.</param>
    [SkipLocalsInit]
    [MethodImpl(MethodImplOptions.NoInlining)]
    public static Float4 Sum<TBlocks, TWeights, F>(in TBlocks blocks, float* kernel, float* rows, int first)
        where TBlocks : struct, IEwaBlocks
        where TWeights : struct, IEwaWeights
        where F : unmanaged, IReal<F>
    {
        TBlocks own = blocks;
        EwaKernel weights = new(kernel, F.Width);
        Float8 one = Float8.Of(1f), columns = Float8.Join(Float4.Iota(0), Float4.Iota(0)), up = Float8.Join(Float4.Zero, Float4.Of(1));
        Float8 sx = Float8.Of(weights.SX), tx = Float8.Of(weights.TX), stepS = sx * Float8.Of(4f), stepT = tx * Float8.Of(4f);
        Float8 blockS = Float8.Fma(columns, sx, up * Float8.Of(weights.SY)), blockT = Float8.Fma(columns, tx, up * Float8.Of(weights.TY));
        Float8 endS = Float8.Of(weights.SEnd), endT = Float8.Of(weights.TEnd), sum = Float8.Zero, other = Float8.Zero;
        float skew = weights.Skew;
        int row = ((int*)rows)[0] + (2 * first), pairs = Math.Min(((int*)rows)[F.Width] - first, EwaRows.Pairs);
        float* pair = rows + (EwaRows.Lead * F.Width);
        for (; pairs > 0; pairs--)
        {
            int column = ((int*)pair)[0];
            Float8 s = blockS + Float8.Of(pair[2 * F.Width]), t = blockT + Float8.Of(pair[3 * F.Width]);
            own.Row(row);
            for (int count = ((int*)pair)[F.Width]; count > 0; count--)
            {
                Float8 shareS = Float8.Max(Float8.Min(endS - Float8.Abs(s), one), Float8.Zero), shareT = Float8.Max(Float8.Min(endT - Float8.Abs(t), one), Float8.Zero);
                own.Add(column, TWeights.Joint(shareS, shareT, s ^ t, skew), ref sum, ref other);
                s += stepS;
                t += stepT;
                column += 4;
            }

            row += 2;
            pair += EwaRows.PairNumbers * F.Width;
        }

        return TBlocks.Total(sum, other);
    }
}
