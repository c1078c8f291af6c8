namespace LabRaytracer;

/// <content>Rays that find out what is seen, without its light.</content>
internal sealed unsafe partial class BatchTracer<R, F, I>
{
    /// <summary>Finds out what each ray of a batch sees and where on its default mapping, and nothing else.</summary>
    /// <param name="rays">The rays.</param>
    /// <param name="objects">Receives the objects' numbers, or <see cref="HitBatch{R, F, I}.Miss"/>.</param>
    /// <param name="u">Receives u where an object is seen.</param>
    public void Probe(RayBatch<R, F, I> rays, int[] objects, double[] u)
    {
        Find(rays);
        new ReadOnlySpan<int>((int*)_hits.Object, rays.Count).CopyTo(objects);
        for (int key = 0; key < _scene.Keys.Count; key++)
        {
            int* order = Surface(rays, key, ViewStage.MappingNeeds, out int count);
            for (int i = 0; i < count; i++)
            {
                u[order[i]] = ViewStage.Map(_scene.Keys[key].Material.DefaultMapping, _buffers.Surfaces, i).U;
            }
        }

        Counters.Charge(RenderStage.Map);
    }

    /// <summary>Finds out what each ray of a batch sees, how far away and how it is turned, and nothing else.</summary>
    /// <param name="rays">The rays.</param>
    /// <param name="edges">Receives it.</param>
    /// <param name="first">Number of the corner that the first ray looks at.</param>
    public void Look(RayBatch<R, F, I> rays, EdgeMarks edges, int first)
    {
        Find(rays);
        for (int key = 0; key < _scene.Keys.Count; key++)
        {
            int* order = Surface(rays, key, SurfaceNeeds.Parameter, out int count);
            SurfaceBatch<R, F, I> s = _buffers.Surfaces;
            for (int i = 0; i < count; i++)
            {
                int ray = order[i];
                edges.Set(first + ray, ((int*)_hits.Object)[ray], 1 / R.Take(_hits.T, ray), new Vector3D(R.Take(s.ShadingX, i), R.Take(s.ShadingY, i), R.Take(s.ShadingZ, i)));
            }
        }

        int* missed = _groups.Order + _groups.Start[_groups.MissKey];
        for (int i = 0; i < _groups.Count[_groups.MissKey]; i++)
        {
            edges.Set(first + missed[i], HitBatch<R, F, I>.Miss, 0, default);
        }

        Counters.Charge(RenderStage.Surface);
    }

    /// <summary>Nearest hits, also on surfaces with an opacity, in groups.</summary>
    private void Find(RayBatch<R, F, I> rays)
    {
        _scene.Nearest(rays, _hits);
        _scene.AlphaSurfaces?.Nearest(rays, _hits, 0, rays.Packets);
        Counters.Charge(RenderStage.Intersect);
        _groups.Sort(rays, _hits);
    }

    /// <summary>Surface points of one group.</summary>
    /// <returns>Numbers of its rays.</returns>
    private int* Surface(RayBatch<R, F, I> rays, int key, SurfaceNeeds needs, out int count)
    {
        int* order = _groups.Order + _groups.Start[key];
        count = _groups.Count[key];
        if (count > 0)
        {
            _scene.Keys[key].Group.Surface(rays, _hits, order, count, _scene.MemberOfObject, _buffers.Surfaces, needs);
        }

        return order;
    }
}
