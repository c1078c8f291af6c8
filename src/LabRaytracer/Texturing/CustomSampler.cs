namespace LabRaytracer;

/// <summary>Looks up a texture that only knows one point at a time: a plain loop over the batch.</summary>
internal sealed unsafe class CustomSampler(ITexture texture, TextureUse use) : TextureSampler
{
    public override void Sample<R, F, I>(in LookupBatch<R> lookups, in ColorColumns<F> colors, int packets)
    {
        bool needsCoordinate = (texture.Needs & TextureNeeds.Coordinate) != 0;
        bool needsPoint = (texture.Needs & TextureNeeds.LocalPoint) != 0;

        // Samples of light from all around are points: there are no columns.
        bool needsFootprint = (texture.Needs & TextureNeeds.Footprint) != 0;
        bool hasFlat = needsFootprint && needsCoordinate && lookups.Footprints.DuDx != null, hasLocal = needsFootprint && needsPoint && lookups.LocalFootprints.XDx != null;
        bool needsWorld = (texture.Needs & TextureNeeds.WorldPoint) != 0, hasWorld = needsFootprint && needsWorld && lookups.WorldFootprints.XDx != null;
        for (int i = 0; i < lookups.Count; i++)
        {
            TextureCoordinate coordinate = needsCoordinate
                ? new(R.Take(lookups.Coordinates.U, i), R.Take(lookups.Coordinates.V, i))
                : default;
            Point3D point = needsPoint
                ? new(R.Take(lookups.Positions.X, i), R.Take(lookups.Positions.Y, i), R.Take(lookups.Positions.Z, i))
                : default;
            Vector3D normal = needsPoint
                ? new(R.Take(lookups.Positions.NormalX, i), R.Take(lookups.Positions.NormalY, i), R.Take(lookups.Positions.NormalZ, i))
                : default;
            PositionBatch<R> at = lookups.Positions;
            Point3D worldPoint = needsWorld ? new(R.Take(at.WorldX, i), R.Take(at.WorldY, i), R.Take(at.WorldZ, i)) : default;
            Vector3D worldNormal = needsWorld ? new(R.Take(at.WorldNormalX, i), R.Take(at.WorldNormalY, i), R.Take(at.WorldNormalZ, i)) : default;
            colors.Put(i, Read(new TextureLookup(
                coordinate, point, normal, lookups.WrapU, lookups.WrapV,
                hasFlat ? lookups.Footprints.Take(i) : default,
                hasLocal ? lookups.LocalFootprints.Take(i) : default)
            {
                WorldPoint = worldPoint, WorldNormal = worldNormal, WorldFootprint = hasWorld ? lookups.WorldFootprints.Take(i) : default,
            }));
        }
    }

    private Intensity Read(in TextureLookup lookup) => use switch
    {
        TextureUse.Alpha => Intensity.Grey(texture.Alpha(lookup)),
        TextureUse.Premultiplied when texture.HasAlpha => texture.Sample(lookup) * texture.Alpha(lookup),
        _ => texture.Sample(lookup),
    };
}
