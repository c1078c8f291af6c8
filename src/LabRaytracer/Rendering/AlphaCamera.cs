namespace LabRaytracer;

/// <summary>Sums up the light of the surfaces with an opacity that rays pass before they meet something opaque.</summary>
/// <remarks>From the nearest to the farthest: light += through * opacity * layer, through *= 1 - opacity.</remarks>
internal sealed unsafe class AlphaCamera<R, F, I>
    where R : unmanaged, ILane<R, F, I>
    where F : unmanaged, ILane<F, F, I>
    where I : unmanaged, IIndexLane<I>
{
    private readonly ColorColumns<F> _light;
    private readonly float* _through;
    private readonly int* _order;
    private readonly bool _isShaded;

    private AlphaCamera(AlphaLayers<R, F, I> layers, bool isShaded, LaneMemory memory, int capacity)
    {
        Layers = layers;
        _isShaded = isShaded;
        _light = new ColorColumns<F>(memory, capacity);
        _through = (float*)memory.Column<F>(capacity, R.Width);
        _order = memory.Column<int>(capacity + R.Width, 1);
        Weights = new ColorColumns<F>(memory, capacity);
    }

    /// <summary>The layers.</summary>
    public AlphaLayers<R, F, I> Layers { get; }

    /// <summary>Weight of each ray where it is now: of its light on the current layer, or, after the last, of what lies behind.</summary>
    public ColorColumns<F> Weights { get; }

    /// <summary>Numbers of the rays that <see cref="Choose"/> chose, padded to whole groups of lanes.</summary>
    public int* Order => _order;

    /// <summary>What a worker needs for a scene; null if no object has an opacity.</summary>
    /// <param name="scene">The scene.</param>
    /// <param name="isShaded">False where surfaces are shown or not: an opacity of 1/2 and more counts as 1, less as 0.</param>
    /// <param name="hasDifferentials">Whether the rays carry differentials.</param>
    /// <param name="counters">Counts lookups.</param>
    /// <param name="memory">Owns the columns.</param>
    /// <param name="capacity">Most rays of a batch.</param>
    public static AlphaCamera<R, F, I>? Of(CompiledScene<R, F, I> scene, bool isShaded, bool hasDifferentials, WorkerCounters counters, LaneMemory memory, int capacity) =>
        scene.AlphaSurfaces is { } surfaces
            ? new AlphaCamera<R, F, I>(new AlphaLayers<R, F, I>(scene, surfaces, counters, memory, capacity, hasDifferentials), isShaded, memory, capacity)
            : null;

    /// <summary>Starts with the rays of a batch and their nearest opaque hits.</summary>
    public void Start(RayBatch<R, F, I> rays, HitBatch<R, F, I> opaque)
    {
        Layers.Start(rays, opaque.T);
        int scalars = rays.Packets * R.Width;
        new Span<float>(_through, scalars).Fill(1);
        new Span<float>((float*)_light.R, scalars).Clear();
        new Span<float>((float*)_light.G, scalars).Clear();
        new Span<float>((float*)_light.B, scalars).Clear();
    }

    /// <summary>Chooses the rays of a group that see something of the current layer; their weights are its light's.</summary>
    /// <param name="order">The group.</param>
    /// <param name="count">How many rays.</param>
    /// <param name="weights">Weights of the batch.</param>
    /// <returns>How many were chosen.</returns>
    public int Choose(int* order, int count, in ColorColumns<F> weights)
    {
        int chosen = 0;
        for (int i = 0; i < count; i++)
        {
            int ray = order[i];
            if (!_isShaded)
            {
                Layers.Opacity[ray] = Layers.Opacity[ray] >= 0.5f ? 1 : 0;
            }

            if (Layers.Opacity[ray] != 0)
            {
                Weights.Put(ray, weights.Take(ray) * (_through[ray] * Layers.Opacity[ray]));
                _order[chosen++] = ray;
            }
        }

        for (int pad = chosen; pad % R.Width != 0; pad++)
        {
            _order[pad] = _order[chosen - 1];
        }

        return chosen;
    }

    /// <summary>Adds the light of the chosen rays.</summary>
    public void Add(int chosen, in ColorColumns<F> radiance)
    {
        for (int i = 0; i < chosen; i++)
        {
            int ray = _order[i];
            _light.Put(ray, _light.Take(ray) + (radiance.Take(ray) * (_through[ray] * Layers.Opacity[ray])));
        }
    }

    /// <summary>Goes behind the current layer: rays of which too little is left end here.</summary>
    /// <param name="count">Rays of the batch.</param>
    /// <param name="weights">Their weights.</param>
    public void Pass(int count, in ColorColumns<F> weights)
    {
        int* objects = (int*)Layers.Hits.Object;
        for (int ray = 0; ray < count; ray++)
        {
            if (objects[ray] != HitBatch<R, F, I>.Miss)
            {
                _through[ray] *= 1 - Layers.Opacity[ray];
                if (_through[ray] * weights.Take(ray).Max < SecondaryStage<R, F, I>.LeastWeight)
                {
                    End(ray);
                }
            }
        }

        Layers.Pass();
    }

    /// <summary>Ends the rays that have more layers before them than are looked at; the others keep what is left of their weights for what lies behind.</summary>
    /// <param name="rays">The rays; those that ended are turned off.</param>
    /// <param name="opaque">Their opaque hits; forgotten where they ended.</param>
    /// <param name="weights">Their weights.</param>
    public void Finish(RayBatch<R, F, I> rays, HitBatch<R, F, I> opaque, in ColorColumns<F> weights)
    {
        int* objects = (int*)Layers.Hits.Object;
        for (int ray = 0; ray < rays.Count; ray++)
        {
            if (objects[ray] != HitBatch<R, F, I>.Miss && R.Take(Layers.Rays.Limit, ray) > 0)
            {
                End(ray);
            }

            Weights.Put(ray, weights.Take(ray) * _through[ray]);
            if (_through[ray] == 0)
            {
                ((int*)opaque.Object)[ray] = HitBatch<R, F, I>.Miss;
                R.Put(rays.Limit, ray, -1);
            }
        }
    }

    /// <summary>Light of the layers and of what lies behind them, in place of the latter.</summary>
    public void Combine(int packets, in ColorColumns<F> radiance)
    {
        F* through = (F*)_through;
        for (int packet = 0; packet < packets; packet++)
        {
            F ended = F.Equal(through[packet], F.Zero);
            radiance.R[packet] = _light.R[packet] + F.Select(ended, F.Zero, through[packet] * radiance.R[packet]);
            radiance.G[packet] = _light.G[packet] + F.Select(ended, F.Zero, through[packet] * radiance.G[packet]);
            radiance.B[packet] = _light.B[packet] + F.Select(ended, F.Zero, through[packet] * radiance.B[packet]);
        }
    }

    private void End(int ray)
    {
        _through[ray] = 0;
        R.Put(Layers.Rays.Limit, ray, -1);
    }
}
