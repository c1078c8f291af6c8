namespace LabRaytracer;

/// <summary>Columns of texture lookups.</summary>
/// <typeparam name="R">Lane type of geometry.</typeparam>
internal unsafe struct LookupBatch<R>
    where R : unmanaged, IReal<R>
{
    /// <summary>Texture coordinates after the uv transform; written if the texture needs them.</summary>
    public CoordinateBatch<R> Coordinates;

    /// <summary>Local points and normals; written if the texture needs them.</summary>
    public PositionBatch<R> Positions;

    /// <summary>What samples cover of texture space; written if the texture needs it.</summary>
    public FootprintColumns Footprints;

    /// <summary>What samples cover of the surface; written if the texture needs it.</summary>
    public LocalFootprintColumns LocalFootprints;

    /// <summary>The same in world space.</summary>
    public LocalFootprintColumns WorldFootprints;

    /// <summary>Wrap that the mapping suggests.</summary>
    public TextureWrap WrapU, WrapV;

    /// <summary>Number of points.</summary>
    public int Count;

    /// <summary>A part of the lookups; the gradients of surfaces' own coordinates, which no texture reads, are left out.</summary>
    /// <param name="packet">First group of lanes.</param>
    /// <param name="packets">Number of groups.</param>
    public readonly LookupBatch<R> Part(int packet, int packets)
    {
        PositionBatch<R> p = Positions;
        return this with
        {
            Coordinates = new CoordinateBatch<R> { U = Coordinates.U + packet, V = Coordinates.V + packet },
            Positions = new PositionBatch<R>
            {
                X = p.X + packet, Y = p.Y + packet, Z = p.Z + packet,
                NormalX = p.NormalX + packet, NormalY = p.NormalY + packet, NormalZ = p.NormalZ + packet,
                WorldX = p.WorldX + packet, WorldY = p.WorldY + packet, WorldZ = p.WorldZ + packet,
                WorldNormalX = p.WorldNormalX + packet, WorldNormalY = p.WorldNormalY + packet, WorldNormalZ = p.WorldNormalZ + packet,
                SurfaceU = p.SurfaceU + packet, SurfaceV = p.SurfaceV + packet,
            },
            Footprints = Footprints.From(packet * R.Width),
            LocalFootprints = LocalFootprints.From(packet * R.Width),
            WorldFootprints = WorldFootprints.From(packet * R.Width),
            Count = Math.Clamp(Count - (packet * R.Width), 0, packets * R.Width),
        };
    }
}
