using System.Runtime.CompilerServices;

namespace LabRaytracer;

/// <summary>Zeros between two places, by Newton's method that falls back to halving where it would leave the bracket.</summary>
/// <remarks>A lane that has converged does not change any more, so that its result does not depend on its neighbours.</remarks>
internal static class TorusRoot
{
    /// <summary>Halving alone gets there, from any bracket.</summary>
    private const int MostSteps = 80;

    /// <summary>The zero of tau³ + p tau + q between two places, between which it is monotone; the upper place if both have the same sign.</summary>
    /// <param name="p">Coefficient.</param>
    /// <param name="q">Coefficient.</param>
    /// <param name="isWanted">Mask of lanes that matter.</param>
    /// <param name="low">Lower place.</param>
    /// <param name="high">Upper place.</param>
    [MethodImpl(MethodImplOptions.NoInlining)]
    public static R Cubic<R>(in R p, in R q, in R isWanted, in R low, in R high)
        where R : unmanaged, IReal<R>
    {
        R atLow = R.Fma(low, R.Fma(low, low, p), q), atHigh = R.Fma(high, R.Fma(high, high, p), q);
        R rises = R.LessOrEqual(atLow, R.Zero);
        R open = isWanted & (rises ^ R.LessOrEqual(atHigh, R.Zero));
        R tau = R.Select(open, (low + high) * R.Of(0.5), high), from = low, to = high;
        for (int step = 0; step < MostSteps && R.Any(open); step++)
        {
            R value = R.Fma(tau, R.Fma(tau, tau, p), q), slope = R.Fma(tau * R.Of(3), tau, p);
            Step(value, slope, rises, ref open, ref tau, ref from, ref to);
        }

        return tau;
    }

    /// <summary>The place where rays enter or leave the tube.</summary>
    /// <param name="line">The rays.</param>
    /// <param name="isWanted">Mask of lanes that matter.</param>
    /// <param name="low">Lower place.</param>
    /// <param name="high">Upper place.</param>
    /// <param name="startsInside">Mask: the lower place is inside.</param>
    [MethodImpl(MethodImplOptions.NoInlining)]
    public static R Find<R>(in TorusLine<R> line, in R isWanted, in R low, in R high, in R startsInside)
        where R : unmanaged, IReal<R>
    {
        R open = isWanted, tau = (low + high) * R.Of(0.5), from = low, to = high;
        for (int step = 0; step < MostSteps && R.Any(open); step++)
        {
            R value = line.Outside(tau, out R slope);
            Step(value, slope, startsInside, ref open, ref tau, ref from, ref to);
        }

        return tau;
    }

    /// <summary>One step of all open lanes; until it is shorter than a few units of the last place of the ring's radius, which is what rounding leaves certain.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void Step<R>(R value, R slope, R rises, ref R open, ref R tau, ref R from, ref R to)
        where R : unmanaged, IReal<R>
    {
        R isBefore = rises ^ R.Less(R.Zero, value);
        from = R.Select(isBefore, tau, from);
        to = R.Select(isBefore, to, tau);
        R newton = tau - (value / slope);
        R middle = (from + to) * R.Of(0.5);
        R next = R.Select(R.Less(from, newton) & R.Less(newton, to), newton, middle);
        R least = R.Of(R.IsSingle ? 4.0 / (1 << 24) : 4.0 / (1L << 53));
        R moves = R.Less(least, R.Abs(next - tau)) & R.Less(least, to - from);
        tau = R.Select(open, next, tau);
        open &= moves;
    }
}
