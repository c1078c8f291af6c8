namespace LabRaytracer;

/// <summary>Samples of the lamps: the light that arrives at a group of hits if nothing is in its way.</summary>
/// <param name="scene">The scene.</param>
/// <param name="buffers">Surface points; receives the light.</param>
/// <param name="places">Where samples lie on lamps; null in scenes whose lamps all have one sample.</param>
/// <param name="skies">Draws samples of light from all around; null in scenes without.</param>
internal sealed unsafe class LampSampler<R, F, I>(
    CompiledScene<R, F, I> scene, ShadingBuffers<R, F, I> buffers, LampPlaces<R, F, I>? places, EnvironmentStage<R, F, I>? skies)
    where R : unmanaged, ILane<R, F, I>
    where F : unmanaged, ILane<F, F, I>
    where I : unmanaged, IIndexLane<I>
{
    /// <summary>Starts a lamp.</summary>
    /// <param name="lamp">Its number.</param>
    /// <param name="order">Numbers of the rays that hit.</param>
    /// <param name="packets">Groups of lanes.</param>
    /// <returns>How many samples it has.</returns>
    public int Begin(int lamp, int* order, int packets)
    {
        int samples = scene.Lights[lamp].SampleCount;
        if (scene.Environments[lamp] is { Table.IsBlack: true })
        {
            return 0;
        }

        if (samples > 1 || scene.Environments[lamp] is not null)
        {
            places!.Begin(lamp, order, packets, samples);
        }

        return samples;
    }

    /// <summary>Takes one sample of a lamp at every hit.</summary>
    /// <param name="lamp">Its number.</param>
    /// <param name="sample">Number of the sample.</param>
    /// <param name="count">Number of hits.</param>
    /// <param name="packets">Groups of lanes.</param>
    public void Sample(int lamp, int sample, int count, int packets)
    {
        Light light = scene.Lights[lamp];
        if (light is IWideLight wide)
        {
            wide.Sample(buffers.Surfaces, buffers.Light, packets);
            return;
        }

        if (scene.Environments[lamp] is { } environment)
        {
            skies!.Sample(environment, sample, buffers.Light, count);
            return;
        }

        int samples = light.SampleCount;
        if (samples > 1)
        {
            places!.Place(sample, packets);
        }

        if (light is IWideAreaLight area)
        {
            area.Sample(buffers.Surfaces, places?.Columns ?? default, buffers.Light, packets);
        }
        else
        {
            SampleEach(light, samples, count, packets);
        }
    }

    /// <summary>A lamp that only knows one point at a time.</summary>
    private void SampleEach(Light light, int samples, int count, int packets)
    {
        LightColumns<R, F> columns = buffers.Light;
        float part = 1f / samples;
        for (int i = 0; i < packets * R.Width; i++)
        {
            int at = Math.Min(i, count - 1);
            Point3D point = new(
                R.Take(buffers.Surfaces.PointX, at), R.Take(buffers.Surfaces.PointY, at), R.Take(buffers.Surfaces.PointZ, at));
            bool arrives = samples > 1
                ? light.TrySample(point, new SquarePoint(R.Take(places!.Columns.S, at), R.Take(places.Columns.T, at)), out LightSample sample)
                : light.TrySample(point, out sample);
            R.Put(columns.DirectionX, i, sample.Direction.X);
            R.Put(columns.DirectionY, i, sample.Direction.Y);
            R.Put(columns.DirectionZ, i, sample.Direction.Z);
            R.Put(columns.Distance, i, sample.Distance);
            columns.Intensity.Put(i, arrives ? sample.Intensity * part : Intensity.Black);
        }
    }
}
