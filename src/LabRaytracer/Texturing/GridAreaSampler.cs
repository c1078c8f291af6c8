namespace LabRaytracer;

/// <summary>The numbered grid's means over footprints, one lookup after the other in doubles.</summary>
/// <param name="grid">The means.</param>
internal sealed unsafe class GridAreaSampler(GridArea grid) : TextureSampler
{
    public override void Sample<R, F, I>(in LookupBatch<R> lookups, in ColorColumns<F> colors, int packets)
    {
        bool hasFootprints = lookups.Footprints.DuDx != null;
        for (int i = 0; i < lookups.Count; i++)
        {
            TextureFootprint footprint = hasFootprints ? lookups.Footprints.Take(i) : default;
            colors.Put(i, grid.Mean(R.Take(lookups.Coordinates.U, i), R.Take(lookups.Coordinates.V, i), footprint, lookups.WrapV));
        }
    }
}
