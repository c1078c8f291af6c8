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

    /// <summary>Wrap that the mapping suggests.</summary>
    public TextureWrap WrapU, WrapV;

    /// <summary>Number of points.</summary>
    public int Count;
}
