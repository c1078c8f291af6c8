namespace LabRaytracer;

/// <summary>Lamps' light through surfaces with an opacity: multiplied by 1 - opacity for each on its way.</summary>
internal sealed unsafe class AlphaShadows<R, F, I>
    where R : unmanaged, ILane<R, F, I>
    where F : unmanaged, ILane<F, F, I>
    where I : unmanaged, IIndexLane<I>
{
    private readonly AlphaLayers<R, F, I> _layers;
    private readonly float* _through;

    private AlphaShadows(AlphaLayers<R, F, I> layers, LaneMemory memory, int capacity)
    {
        _layers = layers;
        _through = (float*)memory.Column<F>(capacity, R.Width);
    }

    /// <summary>What a worker needs for a scene; null if none of its objects with an opacity casts shadows.</summary>
    public static AlphaShadows<R, F, I>? Of(CompiledScene<R, F, I> scene, WorkerCounters counters, LaneMemory memory, int capacity) => scene.AlphaCasters is { } casters
        ? new AlphaShadows<R, F, I>(new AlphaLayers<R, F, I>(scene, casters, counters, memory, capacity, hasDifferentials: false), memory, capacity)
        : null;

    /// <summary>Weakens the light of shadow rays that nothing opaque blocks; where nothing of it is left they are turned off.</summary>
    public void Run(RayBatch<R, F, I> rays, ColorColumns<F> light)
    {
        _layers.Start(rays, rays.Limit);
        if (!_layers.Next())
        {
            return;
        }

        new Span<float>(_through, rays.Packets * R.Width).Fill(1);
        int layer = 1;
        do
        {
            Weaken(rays.Count);
            _layers.Pass();
            layer++;
        }
        while (_layers.Next() && layer <= AlphaLayers<R, F, I>.Most);
        Apply(rays, light);
    }

    private void Weaken(int count)
    {
        int* objects = (int*)_layers.Hits.Object;
        for (int ray = 0; ray < count; ray++)
        {
            if (objects[ray] != HitBatch<R, F, I>.Miss)
            {
                _through[ray] *= 1 - _layers.Opacity[ray];
                if (_through[ray] == 0)
                {
                    R.Put(_layers.Rays.Limit, ray, -1);
                }
            }
        }
    }

    private void Apply(RayBatch<R, F, I> rays, ColorColumns<F> light)
    {
        F* through = (F*)_through;
        for (int packet = 0; packet < rays.Packets; packet++)
        {
            // A ray that is still on after the last layer has more before it than is looked at.
            F share = through[packet] & ~R.MaskToSingle(R.Less(R.Zero, _layers.Rays.Limit[packet]) & R.MaskFromInt32(~I.Equal(_layers.Hits.Object[packet], I.Of(HitBatch<R, F, I>.Miss))));
            light.R[packet] *= share;
            light.G[packet] *= share;
            light.B[packet] *= share;
            rays.Limit[packet] = R.Select(R.MaskFromSingle(F.Equal(share, F.Zero)), R.Of(-1), rays.Limit[packet]);
        }
    }
}
