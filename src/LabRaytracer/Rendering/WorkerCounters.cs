using System.Diagnostics;

namespace LabRaytracer;

/// <summary>Counts and times of one worker.</summary>
internal sealed class WorkerCounters
{
    private readonly long[] _ticks = new long[Enum.GetValues<RenderStage>().Length];
    private long _since;

    public long PrimaryRays, EdgePixels, SecondaryRays, Hits, HitsRefined, LampSamples, ShadowRays, ShadowRaysSkipped, SecondaryRaysSkipped;

    public long Mappings, TextureLookups, AlphaTests, ConstantSlots, UnlitHits, NotFinite;

    public (int X, int Y)? FirstNotFinite;

    /// <summary>Starts the clock.</summary>
    public void Start() => _since = Stopwatch.GetTimestamp();

    /// <summary>Charges the time since the last call to a stage.</summary>
    public void Charge(RenderStage stage)
    {
        long now = Stopwatch.GetTimestamp();
        _ticks[(int)stage] += now - _since;
        _since = now;
    }

    /// <summary>Notes a pixel that is not finite.</summary>
    public void Report(int x, int y)
    {
        NotFinite++;
        if (FirstNotFinite is not { } known || (y, x).CompareTo((known.Y, known.X)) < 0)
        {
            FirstNotFinite = (x, y);
        }
    }

    /// <summary>Adds these counts to a render's statistics.</summary>
    public void AddTo(RenderStatistics statistics, double[] stageSeconds)
    {
        statistics.PrimaryRays += PrimaryRays;
        statistics.EdgePixels += EdgePixels;
        statistics.SecondaryRays += SecondaryRays;
        statistics.Hits += Hits;
        statistics.HitsRefined += HitsRefined;
        statistics.LampSamples += LampSamples;
        statistics.ShadowRays += ShadowRays;
        statistics.ShadowRaysSkipped += ShadowRaysSkipped;
        statistics.SecondaryRaysSkipped += SecondaryRaysSkipped;
        statistics.Mappings += Mappings;
        statistics.TextureLookups += TextureLookups;
        statistics.AlphaTests += AlphaTests;
        statistics.ConstantSlots += ConstantSlots;
        statistics.UnlitHits += UnlitHits;
        statistics.NotFinitePixels += NotFinite;
        if (FirstNotFinite is { } first && (statistics.FirstNotFinitePixel is not { } known || (first.Y, first.X).CompareTo((known.Y, known.X)) < 0))
        {
            statistics.FirstNotFinitePixel = first;
        }

        for (int stage = 0; stage < _ticks.Length; stage++)
        {
            stageSeconds[stage] += Stopwatch.GetElapsedTime(0, _ticks[stage]).TotalSeconds;
        }
    }
}
