using System.Runtime.CompilerServices;

namespace LabRaytracer;

/// <summary>How a pattern that a pixel can no longer resolve gives way to its mean.</summary>
internal static class FilterFade
{
    /// <summary>Share of a wave that is kept, [0, 1]: 1 up to a quarter of a period, 0 from half a period on (two samples a period), smooth in between.</summary>
    /// <param name="periods">Width of the filter in periods of the wave, at least 0.</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static F Kept<F>(F periods)
        where F : unmanaged, IReal<F>
    {
        F share = F.Min(F.Max(F.Of(2) - (periods * F.Of(4)), F.Zero), F.Of(1));
        return share * share * (F.Of(3) - (share + share));
    }

    /// <summary>The mean where nothing is kept, the pattern where all is: exactly, so that it does not matter whether a lane that shows one computes the other.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static F Mix<F>(F mean, F pattern, F kept)
        where F : unmanaged, IReal<F> => F.Select(
            F.LessOrEqual(F.Of(1), kept), pattern, F.Select(F.LessOrEqual(kept, F.Zero), mean, Lattice.Lerp(mean, pattern, kept)));
}
