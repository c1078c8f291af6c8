namespace LabRaytracer;

/// <summary>The columns that shading of one batch passes through; owned by one worker.</summary>
internal sealed unsafe class ShadingBuffers<R, F, I>
    where R : unmanaged, ILane<R, F, I>
    where F : unmanaged, ILane<F, F, I>
    where I : unmanaged, IIndexLane<I>
{
    /// <param name="scene">The scene, for the number of columns that its materials need.</param>
    /// <param name="memory">Owns the columns.</param>
    /// <param name="capacity">Most hits of a batch.</param>
    /// <param name="hasFootprints">Whether rays carry differentials.</param>
    public ShadingBuffers(CompiledScene<R, F, I> scene, LaneMemory memory, int capacity, bool hasFootprints)
    {
        Surfaces = new SurfaceBatch<R, F, I>(memory, capacity);
        Light = new LightColumns<R, F>(memory, capacity);
        ShadowRays = new RayBatch<R, F, I>(memory, capacity, directions: new VectorColumns<R>(Light.DirectionX, Light.DirectionY, Light.DirectionZ));
        Radiance = new ColorColumns<F>(memory, capacity);
        DirectionX = memory.Column<R>(capacity, R.Width);
        DirectionY = memory.Column<R>(capacity, R.Width);
        DirectionZ = memory.Column<R>(capacity, R.Width);
        Inside = memory.Column<R>(capacity, R.Width);
        IEnumerable<CompiledMaterial> skies = scene.Environments.OfType<CompiledEnvironment>().Select(environment => environment.Sky);
        LookupList[] lists = [.. scene.Keys.Select(key => key.Material).Append(scene.Background).Concat(skies).SelectMany(material => material.AllTextures)];
        Coordinates = new CoordinateBatch<R>[Math.Max(1, lists.Max(list => list.Coordinates.Count))];
        for (int set = 0; set < Coordinates.Length; set++)
        {
            Coordinates[set] = new CoordinateBatch<R> { U = memory.Column<R>(capacity, R.Width), V = memory.Column<R>(capacity, R.Width) };
        }

        Footprints = hasFootprints ? new FootprintBuffers<R, F, I>(memory, capacity, Coordinates.Length) : null;
        Texels = new ColorColumns<F>[Math.Max(1, lists.Max(list => list.Lookups.Count))];
        for (int lookup = 0; lookup < Texels.Length; lookup++)
        {
            Texels[lookup] = new ColorColumns<F>(memory, capacity);
        }
    }

    /// <summary>Points and normals; after facing the viewer, normals point to the viewer's side.</summary>
    public SurfaceBatch<R, F, I> Surfaces { get; }

    /// <summary>Directions of the rays that hit.</summary>
    public R* DirectionX { get; }

    /// <summary>Directions of the rays that hit.</summary>
    public R* DirectionY { get; }

    /// <summary>Directions of the rays that hit.</summary>
    public R* DirectionZ { get; }

    /// <summary>Mask of hits from inside.</summary>
    public R* Inside { get; }

    /// <summary>Texture coordinates, one set a distinct mapping of the material.</summary>
    public CoordinateBatch<R>[] Coordinates { get; }

    /// <summary>What samples cover of surfaces and textures; null if rays carry no differentials: every sample is a point.</summary>
    public FootprintBuffers<R, F, I>? Footprints { get; }

    /// <summary>Texture colours, one set a distinct texture of the material.</summary>
    public ColorColumns<F>[] Texels { get; }

    /// <summary>Light of the current lamp.</summary>
    public LightColumns<R, F> Light { get; }

    /// <summary>Rays towards the current lamp; their directions are those of its light.</summary>
    public RayBatch<R, F, I> ShadowRays { get; }

    /// <summary>Light that leaves the hits towards the viewer.</summary>
    public ColorColumns<F> Radiance { get; }
}
