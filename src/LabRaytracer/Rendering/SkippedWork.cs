namespace LabRaytracer;

/// <summary>Work of one kind that a render left out.</summary>
/// <param name="Item">What, in words.</param>
/// <param name="Count">How often, at least 0.</param>
/// <param name="Seconds">
/// What it would have cost, seconds summed over threads: the count times the mean cost of the same kind of work in the same render; null where the render did none of it.
/// Rather too much than too little: lookups that share a texture or a mapping share its cost.
/// </param>
/// <remarks>Immutable, thread safe.</remarks>
public sealed record SkippedWork(string Item, long Count, double? Seconds)
{
    /// <summary>Everything that a render left out.</summary>
    internal static IReadOnlyList<SkippedWork> Of(RenderStatistics s)
    {
        double textures = Stage(s, RenderStage.Map) + Stage(s, RenderStage.Texture), lamps = Stage(s, RenderStage.Light);
        return
        [
            Estimate("lookups of constant coefficients", s.ConstantSlots, textures, s.TextureLookups),
            Estimate("shadow rays to where no light comes from", s.ShadowRaysSkipped, lamps, s.ShadowRays),
            Estimate("shadow rays from surfaces that no lamp changes", s.UnlitHits, lamps, s.ShadowRays),
            Estimate("reflected and refracted rays too faint", s.SecondaryRaysSkipped, s.StageSeconds.Values.Sum(), s.PrimaryRays + s.SecondaryRays),
            Estimate("textures that no pixel can show", s.TexturesSkipped, s.PrepareSeconds, s.Textures),
        ];
    }

    private static SkippedWork Estimate(string item, long count, double seconds, long done) => new(item, count, done == 0 ? null : count * seconds / done);

    private static double Stage(RenderStatistics statistics, RenderStage stage) => statistics.StageSeconds.GetValueOrDefault(stage.ToString());
}
