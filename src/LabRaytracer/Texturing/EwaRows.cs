using System.Runtime.CompilerServices;

namespace LabRaytracer;

/// <summary>Which texels may lie inside the footprints of a group of lookups: pairs of rows, and in each of them blocks of four columns.</summary>
/// <remarks>
/// Found for all lookups at once, some pairs at a time. Found lookup by lookup, one number waits for the next, and the processor does not look far enough ahead to do something else.
/// Rows and columns are whole numbers, a few hundred at most, exact as floats.
/// </remarks>
internal static unsafe class EwaRows
{
    /// <summary>Most pairs of rows that are there at a time.</summary>
    public const int Pairs = 8;

    /// <summary>Groups of numbers of a pair: its first column, its blocks, and s and t at its first texel.</summary>
    public const int PairNumbers = 4;

    /// <summary>Groups of numbers before those of the pairs: the first row, and how many pairs there are.</summary>
    public const int Lead = 2;

    /// <summary>Groups of numbers in all.</summary>
    public const int Numbers = Lead + (Pairs * PairNumbers);

    /// <summary>Writes the first rows and how many pairs there are.</summary>
    /// <param name="kernels">What <see cref="EwaKernel.Store"/> wrote.</param>
    /// <param name="isRead">Mask of the lookups that matter.</param>
    /// <param name="rows">Receives <see cref="Lead"/> groups of numbers.</param>
    /// <returns>The most pairs of a lookup.</returns>
    [MethodImpl(MethodImplOptions.NoInlining)]
    public static int Begin<F, I>(F* kernels, F isRead, F* rows)
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I>
    {
        F center = kernels[EwaKernel.CenterYNumber], reach = kernels[EwaKernel.ReachYNumber], bottom = -F.Floor(reach - center);
        I pairs = F.MaskToInt32(isRead) & (F.ToInt32((center + reach - bottom) * F.Of(0.5)) + I.Of(1));
        I.Store(F.ToInt32(bottom), (int*)rows);
        I.Store(pairs, (int*)(rows + 1));
        return (int)F.Largest(F.FromInt32(pairs));
    }

    /// <summary>Writes the next pairs of rows.</summary>
    /// <param name="kernels">What <see cref="EwaKernel.Store"/> wrote.</param>
    /// <param name="rows">What <see cref="Begin"/> wrote; receives the pairs behind it.</param>
    /// <param name="first">Number of the first pair.</param>
    /// <param name="count">How many, at most <see cref="Pairs"/>.</param>
    [MethodImpl(MethodImplOptions.NoInlining)]
    public static void Find<F, I>(F* kernels, F* rows, int first, int count)
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I>
    {
        F sx = kernels[EwaKernel.SXNumber], sy = kernels[EwaKernel.SYNumber], tx = kernels[EwaKernel.TXNumber], ty = kernels[EwaKernel.TYNumber];
        F centerX = kernels[EwaKernel.CenterXNumber], reachX = kernels[EwaKernel.ReachXNumber], left = centerX - reachX, right = centerX + reachX;
        F slantS = kernels[EwaKernel.SlantSNumber], reachS = kernels[EwaKernel.ReachSNumber], slantT = kernels[EwaKernel.SlantTNumber], reachT = kernels[EwaKernel.ReachTNumber];
        F centerS = -sx * centerX, centerT = -tx * centerX, half = F.Of(0.5), two = F.Of(2);
        F y = F.FromInt32(I.Load((int*)rows) + I.Of(2 * first)) - kernels[EwaKernel.CenterYNumber];
        F* pair = rows + Lead;
        for (int k = 0; k < count; k++)
        {
            F middle = y + half, middleS = F.Fma(slantS, middle, centerX), middleT = F.Fma(slantT, middle, centerX);
            F start = -F.Floor(-F.Max(F.Max(middleS - reachS, middleT - reachT), left)), end = F.Min(F.Min(middleS + reachS, middleT + reachT), right);
            I.Store(F.ToInt32(start), (int*)pair);
            I.Store(F.ToInt32(F.Floor(F.Fma(end - start, F.Of(0.25), F.Of(1)))), (int*)(pair + 1));
            pair[2] = F.Fma(sx, start, F.Fma(sy, y, centerS));
            pair[3] = F.Fma(tx, start, F.Fma(ty, y, centerT));
            pair += PairNumbers;
            y += two;
        }
    }
}
