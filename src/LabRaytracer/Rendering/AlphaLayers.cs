namespace LabRaytracer;

/// <summary>Follows rays straight through surfaces with an opacity, one layer after the other.</summary>
/// <remarks>Owned by one worker; only there in scenes with such surfaces.</remarks>
internal sealed unsafe class AlphaLayers<R, F, I>
    where R : unmanaged, ILane<R, F, I>
    where F : unmanaged, ILane<F, F, I>
    where I : unmanaged, IIndexLane<I>
{
    /// <summary>Most layers that a ray passes; what lies behind them is black, and in their shadow.</summary>
    public const int Most = 256;

    private readonly CompiledScene<R, F, I> _scene;
    private readonly SceneBvh<R, F, I> _surfaces;
    private readonly WorkerCounters _counters;
    private readonly ShadingBuffers<R, F, I> _buffers;
    private readonly R* _exitX;
    private readonly R* _exitY;
    private readonly R* _exitZ;

    /// <param name="scene">The scene.</param>
    /// <param name="surfaces">The objects with an opacity.</param>
    /// <param name="counters">Counts lookups.</param>
    /// <param name="memory">Owns the columns.</param>
    /// <param name="capacity">Most rays of a batch.</param>
    /// <param name="hasDifferentials">Whether the rays carry differentials.</param>
    public AlphaLayers(
        CompiledScene<R, F, I> scene, SceneBvh<R, F, I> surfaces, WorkerCounters counters, LaneMemory memory, int capacity, bool hasDifferentials)
    {
        _scene = scene;
        _surfaces = surfaces;
        _counters = counters;
        _buffers = new ShadingBuffers<R, F, I>(scene, memory, capacity, hasDifferentials);
        Rays = new RayBatch<R, F, I>(memory, capacity, hasDifferentials);
        Hits = new HitBatch<R, F, I>(memory, capacity);
        Groups = new HitGroups<R, F, I>(scene, memory, capacity);
        Travelled = memory.Column<R>(capacity, R.Width);
        Opacity = (float*)memory.Column<F>(capacity, R.Width);
        _exitX = memory.Column<R>(capacity, R.Width);
        _exitY = memory.Column<R>(capacity, R.Width);
        _exitZ = memory.Column<R>(capacity, R.Width);
    }

    /// <summary>The rays, from behind the last layer that they passed; off where nothing is left to find.</summary>
    public RayBatch<R, F, I> Rays { get; }

    /// <summary>Hits on the current layer.</summary>
    public HitBatch<R, F, I> Hits { get; }

    /// <summary>The same by material.</summary>
    public HitGroups<R, F, I> Groups { get; }

    /// <summary>How far each ray had come before the current layer's distance.</summary>
    public R* Travelled { get; }

    /// <summary>Opacity of the current layer where each ray meets it, [0, 1].</summary>
    public float* Opacity { get; }

    /// <summary>Starts with rays and how far they are of interest.</summary>
    /// <param name="rays">The rays.</param>
    /// <param name="limit">Limits, excluded; below 0 for rays that are off.</param>
    public void Start(RayBatch<R, F, I> rays, R* limit)
    {
        Rays.Count = rays.Count;
        for (int packet = 0; packet < rays.Packets; packet++)
        {
            Rays.OriginX[packet] = rays.OriginX[packet];
            Rays.OriginY[packet] = rays.OriginY[packet];
            Rays.OriginZ[packet] = rays.OriginZ[packet];
            Rays.DirectionX[packet] = rays.DirectionX[packet];
            Rays.DirectionY[packet] = rays.DirectionY[packet];
            Rays.DirectionZ[packet] = rays.DirectionZ[packet];
            Rays.Limit[packet] = limit[packet];
            Travelled[packet] = R.Zero;
        }

        if (Rays.HasDifferentials)
        {
            Rays.Differentials.CopyFrom(rays.Differentials, rays.Packets);
        }
    }

    /// <summary>Finds the next layer and its opacity.</summary>
    /// <returns>False if no ray meets any.</returns>
    public bool Next()
    {
        Hits.Clear(Rays);
        Rays.Renew();
        _surfaces.Nearest(Rays, Hits, 0, Rays.Packets);
        Groups.Sort(Rays, Hits);
        bool any = false;
        for (int key = 0; key < _scene.Keys.Count; key++)
        {
            int count = Groups.Count[key];
            if (count > 0)
            {
                any = true;
                Look(_scene.Keys[key], Groups.Order + Groups.Start[key], count);
            }
        }

        return any;
    }

    /// <summary>Takes the rays that met the current layer behind it and turns the others off.</summary>
    public void Pass()
    {
        R zero = R.Zero, off = R.Of(-1);
        I miss = I.Of(HitBatch<R, F, I>.Miss);
        for (int packet = 0; packet < Rays.Packets; packet++)
        {
            R x = _exitX[packet] - Rays.OriginX[packet], y = _exitY[packet] - Rays.OriginY[packet], z = _exitZ[packet] - Rays.OriginZ[packet];
            R way = Lane.Dot(x, y, z, Rays.DirectionX[packet], Rays.DirectionY[packet], Rays.DirectionZ[packet]);
            R rest = Rays.Limit[packet] - way;
            R missed = R.MaskFromInt32(I.Equal(Hits.Object[packet], miss)) | R.LessOrEqual(rest, zero);
            Rays.Limit[packet] = R.Select(missed, off, rest);
            Rays.OriginX[packet] = R.Select(missed, Rays.OriginX[packet], _exitX[packet]);
            Rays.OriginY[packet] = R.Select(missed, Rays.OriginY[packet], _exitY[packet]);
            Rays.OriginZ[packet] = R.Select(missed, Rays.OriginZ[packet], _exitZ[packet]);
            Travelled[packet] += R.Select(missed, zero, way);
            if (Rays.HasDifferentials)
            {
                Rays.Differentials.Advance(packet, R.ToSingle(R.Select(missed, zero, way)));
            }
        }
    }

    /// <summary>Opacity where a group of rays meets the layer, and where they leave it.</summary>
    private void Look(ShadingKey<R, F, I> key, int* order, int count)
    {
        CompiledOpacity opacity = key.Material.Opacity!;
        SurfaceBatch<R, F, I> s = _buffers.Surfaces;
        key.Group.Surface(Rays, Hits, order, count, _scene.MemberOfObject, s, opacity.Lookups.Needs);
        ViewerStage.Run(Rays, Hits, order, count, keepsDirections: true, _buffers);
        if (Rays.HasDifferentials && opacity.Lookups.NeedsFootprints)
        {
            FootprintStage.Step(key.Group, Rays, Hits, order, count, _scene.MemberOfObject, _buffers, opacity.Lookups.Steps);
        }

        TextureStage.Run(opacity.Lookups, _buffers, count, _counters);
        _counters.AlphaTests += count;
        for (int packet = 0; packet * R.Width < count; packet++)
        {
            F value = opacity.Value.Read(_buffers.Texels, packet);

            // NaN stays: it is the pixel that has to show it.
            value = F.Select(F.Less(value, F.Zero), F.Zero, F.Select(F.Less(F.Of(1), value), F.Of(1), value));
            R back = -s.Slack[packet];
            R x = R.Fma(back, s.NormalX[packet], s.PointX[packet]);
            R y = R.Fma(back, s.NormalY[packet], s.PointY[packet]);
            R z = R.Fma(back, s.NormalZ[packet], s.PointZ[packet]);
            for (int lane = 0; lane < R.Width && (packet * R.Width) + lane < count; lane++)
            {
                int ray = order[(packet * R.Width) + lane];
                Opacity[ray] = (float)F.Get(value, lane);
                R.Put(_exitX, ray, R.Get(x, lane));
                R.Put(_exitY, ray, R.Get(y, lane));
                R.Put(_exitZ, ray, R.Get(z, lane));
            }
        }
    }
}
