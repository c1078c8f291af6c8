using System.Runtime.CompilerServices;

namespace LabRaytracer;

/// <summary>Takes a batch of rays through all stages: hits, groups, surfaces, textures, lamps, secondary rays.</summary>
/// <remarks>Owned by one worker; nothing is allocated per batch.</remarks>
internal sealed unsafe partial class BatchTracer<R, F, I>
    where R : unmanaged, ILane<R, F, I>
    where F : unmanaged, ILane<F, F, I>
    where I : unmanaged, IIndexLane<I>
{
    private readonly CompiledScene<R, F, I> _scene;
    private readonly RenderOptions _options;
    private readonly HitBatch<R, F, I> _hits;
    private readonly HitGroups<R, F, I> _groups;
    private readonly ShadingBuffers<R, F, I> _buffers;
    private readonly LightStage<R, F, I> _lights;
    private readonly SecondaryStage<R, F, I> _secondaryStage;
    private readonly SecondaryRays<R, F, I> _secondary;
    private readonly StepNeeds _steps;
    private readonly SurfaceNeeds _needs;
    private readonly PixelSampling? _sampling;
    private readonly AlphaCamera<R, F, I>? _alpha;
    private readonly SideSplit<R, F, I>? _sides;
    private readonly ReliefStage<R, F, I>? _relief;

    public BatchTracer(
        CompiledScene<R, F, I> scene, RenderOptions options, LaneMemory memory, WorkerCounters counters, int capacity, PixelSampling? sampling)
    {
        _sampling = sampling;
        _scene = scene;
        _options = options;
        _needs = ViewStage.Needs(options.View) | (options.Precision == Precision.Exact ? SurfaceNeeds.Sharp : SurfaceNeeds.None);
        Counters = counters;
        Capacity = capacity;
        _hits = new HitBatch<R, F, I>(memory, capacity);
        _groups = new HitGroups<R, F, I>(scene, memory, capacity);
        _steps = FilterView.Is(options.View) ? StepNeeds.Local | StepNeeds.SurfaceGradient : StepNeeds.None;
        HasDifferentials = scene.NeedsDifferentials || FilterView.Is(options.View);
        _buffers = new ShadingBuffers<R, F, I>(scene, memory, capacity, HasDifferentials);
        _secondary = new SecondaryRays<R, F, I>(memory, capacity);
        _secondaryStage = new SecondaryStage<R, F, I>(_buffers, _secondary, counters, memory, capacity, scene.IsSkipping);
        Radiance = new ColorColumns<F>(memory, capacity);
        Weights = new ColorColumns<F>(memory, capacity);
        Pixels = memory.Column<I>(capacity, I.Width);
        Tally = options.View == RenderView.Cost ? new RayTally((int*)Pixels, capacity) : null;
        LampPlaces<R, F, I>? places = sampling is null ? null : new LampPlaces<R, F, I>(sampling, (int*)Pixels, memory, capacity);
        EnvironmentStage<R, F, I>? skies = scene.Environments.All(environment => environment is null)
            ? null
            : new EnvironmentStage<R, F, I>(scene, places!, counters, memory, capacity);
        LampSampler<R, F, I> lamps = new(scene, _buffers, places, skies);
        _relief = ReliefStage<R, F, I>.Of(scene, _buffers, memory, capacity);
        _sides = scene.Keys.Any(key => key.Material.Inside is not null) ? new SideSplit<R, F, I>(memory, capacity) : null;
        _alpha = AlphaCamera<R, F, I>.Of(scene, ViewStage.IsShaded(options.View), HasDifferentials, counters, memory, capacity);
        _lights = new LightStage<R, F, I>(scene, _buffers, lamps, counters, Tally, AlphaShadows<R, F, I>.Of(scene, counters, memory, capacity));
    }

    /// <summary>Tells whether rays must carry differentials, because some texture is filtered.</summary>
    public bool HasDifferentials { get; }

    /// <summary>Most rays of a batch.</summary>
    public int Capacity { get; }

    /// <summary>Counts and times.</summary>
    public WorkerCounters Counters { get; }

    /// <summary>Result: light that each ray of the batch brings, unweighted. Whoever keeps the columns gives others for them.</summary>
    public ColorColumns<F> Radiance { get; set; }

    /// <summary>Weight of each ray of the batch.</summary>
    public ColorColumns<F> Weights { get; }

    /// <summary>Pixel of each ray of the batch.</summary>
    public I* Pixels { get; }

    /// <summary>Counts rays by pixel; null if nobody asks.</summary>
    public RayTally? Tally { get; }

    /// <summary>Traces a batch.</summary>
    /// <param name="rays">The rays.</param>
    /// <param name="depth">Reflections and refractions so far.</param>
    /// <param name="queue">Receives the reflected and refracted rays.</param>
    public void Trace(RayBatch<R, F, I> rays, int depth, SecondaryQueue<R, F, I> queue)
    {
        _sampling?.StartDepth(depth);
        _secondary.Start(queue);
        Tally?.Add(rays);
        _scene.Nearest(rays, _hits);
        Counters.Charge(RenderStage.Intersect);
        bool passed = _alpha is not null && TraceLayers(_alpha, rays, depth);
        ColorColumns<F> weights = passed ? _alpha!.Weights : Weights;
        _groups.Sort(rays, _hits);
        Counters.Charge(RenderStage.Group);
        for (int key = 0; key < _scene.Keys.Count; key++)
        {
            if (_groups.Count[key] > 0)
            {
                Shade(_scene.Keys[key], rays, _hits, _groups.Order + _groups.Start[key], _groups.Count[key], depth, weights);
            }
        }

        int missed = _groups.Count[_groups.MissKey];
        if (missed > 0)
        {
            int* order = _groups.Order + _groups.Start[_groups.MissKey];
            BackgroundStage.Run(_scene, rays, order, missed, _buffers, Counters);
            Scatter(order, missed);
        }

        if (passed)
        {
            _alpha!.Combine(rays.Packets, Radiance);
        }

        Counters.HitsRefined += _hits.Refined;
        _secondary.LineUp(rays.Count);
        Counters.Charge(RenderStage.Combine);
    }

    /// <summary>Follows a batch through the surfaces with an opacity before its opaque hits.</summary>
    /// <returns>False if it meets none.</returns>
    private bool TraceLayers(AlphaCamera<R, F, I> alpha, RayBatch<R, F, I> rays, int depth)
    {
        alpha.Start(rays, _hits);
        if (!alpha.Layers.Next())
        {
            return false;
        }

        int layer = 1;
        do
        {
            for (int key = 0; key < _scene.Keys.Count; key++)
            {
                ShadeLayer(alpha, key, depth);
            }

            _secondary.EndLayer(rays.Count);
            alpha.Pass(rays.Count, Weights);
            layer++;
        }
        while (alpha.Layers.Next() && layer <= AlphaLayers<R, F, I>.Most);
        alpha.Finish(rays, _hits, Weights);
        return true;
    }

    /// <summary>Light of the hits of the current layer on one material.</summary>
    private void ShadeLayer(AlphaCamera<R, F, I> alpha, int key, int depth)
    {
        HitGroups<R, F, I> groups = alpha.Layers.Groups;
        int chosen = groups.Count[key] == 0 ? 0 : alpha.Choose(groups.Order + groups.Start[key], groups.Count[key], Weights);
        if (chosen > 0)
        {
            Shade(_scene.Keys[key], alpha.Layers.Rays, alpha.Layers.Hits, alpha.Order, chosen, depth, alpha.Weights, alpha.Layers.Travelled);
            alpha.Add(chosen, Radiance);
        }
    }

    private void Shade(
        ShadingKey<R, F, I> key, RayBatch<R, F, I> rays, HitBatch<R, F, I> hits, int* order, int count, int depth, in ColorColumns<F> weights, R* travelled = null)
    {
        if (key.Material.Inside is not { } inside || _sides is null)
        {
            ShadeSide(key.Material, key, rays, hits, order, count, depth, weights, travelled);
            return;
        }

        key.Group.Surface(rays, hits, order, count, _scene.MemberOfObject, _buffers.Surfaces, SurfaceNeeds.None);
        ViewerStage.Run(rays, hits, order, count, keepsDirections: false, _buffers);
        _sides.Run(order, count, _buffers.Inside);
        ShadeSide(key.Material, key, rays, hits, _sides.Outside, _sides.OutsideCount, depth, weights, travelled);
        ShadeSide(inside, key, rays, hits, _sides.Inside, _sides.InsideCount, depth, weights, travelled);
    }

    private void ShadeSide(
        CompiledMaterial material,
        ShadingKey<R, F, I> key,
        RayBatch<R, F, I> rays,
        HitBatch<R, F, I> hits,
        int* order,
        int count,
        int depth,
        in ColorColumns<F> weights,
        R* travelled)
    {
        if (count == 0)
        {
            return;
        }

        StepNeeds steps = HasDifferentials ? material.Steps | _steps : StepNeeds.None;
        SurfaceNeeds stepColumns = (steps & StepNeeds.Normal) != 0 ? SurfaceNeeds.LocalPoint : SurfaceNeeds.None;
        key.Group.Surface(rays, hits, order, count, _scene.MemberOfObject, _buffers.Surfaces, material.Needs | _needs | stepColumns);
        Counters.Hits += count;
        ViewerStage.Run(rays, hits, order, count, ReadsDirections(material), _buffers);
        if (steps != StepNeeds.None)
        {
            FootprintStage.Step(key.Group, rays, hits, order, count, _scene.MemberOfObject, _buffers, steps);
        }

        Counters.Charge(RenderStage.Surface);
        if (ViewStage.IsShaded(_options.View))
        {
            TextureStage.Run(material, _buffers, count, Counters);
            Tilt(material, key, rays, hits, order, count);
            _lights.Run(material, order, count);
            if (material.HasSecondaryRays && depth < _options.MaxDepth)
            {
                _secondaryStage.Run(material, rays, order, count, weights, Pixels);
            }
        }
        else
        {
            if (_options.View == RenderView.Normal && material.Relief is not null)
            {
                TextureStage.Run(material, _buffers, count, Counters);
                Tilt(material, key, rays, hits, order, count);
            }

            ViewStage.Run(_options.View, hits, travelled, order, count, material, _buffers);
        }

        Scatter(order, count);
        Counters.Charge(RenderStage.Combine);
    }

    /// <summary>Tells whether light or normals of a material depend on where rays come from.</summary>
    private static bool ReadsDirections(CompiledMaterial material) => !MatteLight.IsMatte(material) || material.HasSecondaryRays || material.Relief is not null;

    /// <summary>Tilts normals by heights and normal maps, if the material has any.</summary>
    private void Tilt(CompiledMaterial material, ShadingKey<R, F, I> key, RayBatch<R, F, I> rays, HitBatch<R, F, I> hits, int* order, int count)
    {
        if (material.Relief is not null)
        {
            _relief!.Run(material, key.Group, rays, hits, order, count);
            Counters.Charge(RenderStage.Surface);
        }
    }

    /// <summary>Radiance of a group back into the order of the batch.</summary>
    private void Scatter(int* order, int count)
    {
        Scatter(order, count, (float*)_buffers.Radiance.R, (float*)Radiance.R);
        Scatter(order, count, (float*)_buffers.Radiance.G, (float*)Radiance.G);
        Scatter(order, count, (float*)_buffers.Radiance.B, (float*)Radiance.B);
    }

    private static void Scatter(int* order, int count, float* from, float* to)
    {
        // A group is often one run of consecutive rays.
        if (order[count - 1] - order[0] == count - 1)
        {
            new ReadOnlySpan<float>(from, count).CopyTo(new Span<float>(to + order[0], count));
            return;
        }

        for (int first = 0; first < count; first += F.Width)
        {
            int end = Math.Min(first + F.Width, count);
            if (end - first == F.Width && order[end - 1] - order[first] == F.Width - 1)
            {
                Unsafe.WriteUnaligned(to + order[first], *(F*)(from + first));
                continue;
            }

            for (int i = first; i < end; i++)
            {
                to[order[i]] = from[i];
            }
        }
    }
}
