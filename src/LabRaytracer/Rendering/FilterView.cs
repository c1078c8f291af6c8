namespace LabRaytracer;

/// <summary>The views that show what a texture filter is up to: how many texels a sample covers, along and in area, and how much longer than wide it is on the texture.</summary>
internal static unsafe class FilterView
{
    /// <summary>Tells whether a view is one of these.</summary>
    public static bool Is(RenderView view) => view is RenderView.Mip or RenderView.Stretch or RenderView.Density;

    /// <summary>Writes the view's colours as radiance.</summary>
    /// <param name="view">Which of them.</param>
    /// <param name="material">The material.</param>
    /// <param name="buffers">Surfaces and steps of the group.</param>
    /// <param name="count">How many hits.</param>
    public static void Run<R, F, I>(RenderView view, CompiledMaterial material, ShadingBuffers<R, F, I> buffers, int count)
        where R : unmanaged, ILane<R, F, I>
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I>
    {
        foreach (CompiledLookup lookup in material.Lookups)
        {
            if (lookup.Coordinates >= 0 && lookup.Sampler?.FindAxes(material.Coordinates[lookup.Coordinates].Mapping) is { } axes)
            {
                FootprintStage.Map(material.Coordinates[lookup.Coordinates], buffers.Surfaces, buffers.Footprints!, lookup.Coordinates, count);
                FootprintColumns footprints = buffers.Footprints!.Sets[lookup.Coordinates];
                for (int i = 0; i < count; i++)
                {
                    (double longer, double shorter) = Sides(footprints.Take(i), axes.Across.Size, axes.Up.Size);
                    buffers.Radiance.Put(i, view switch
                    {
                        RenderView.Mip => LevelColor(longer < 1 ? -1 : Elementary.Log2(new Double1(longer)).Value),
                        RenderView.Density => DensityColor(longer * shorter),
                        _ => SampleHeat.Color(longer / Math.Max(shorter, longer * 1e-6)),
                    });
                }

                return;
            }
        }

        for (int i = 0; i < count; i++)
        {
            buffers.Radiance.Put(i, TexelView.NoPicture);
        }
    }

    /// <summary>Sides of the rectangle that is as long and as wide as a footprint: square roots of the eigenvalues of a a' + b b' for its steps a and b.</summary>
    /// <param name="footprint">The footprint.</param>
    /// <param name="width">Texels along u.</param>
    /// <param name="height">Texels along v.</param>
    public static (double Longer, double Shorter) Sides(in TextureFootprint footprint, int width, int height)
    {
        (double ax, double ay, double bx, double by) = (footprint.DuDx * width, footprint.DvDx * height, footprint.DuDy * width, footprint.DvDy * height);
        double xx = (ax * ax) + (bx * bx), yy = (ay * ay) + (by * by), xy = (ax * ay) + (bx * by), half = (xx - yy) / 2;
        double longer = Math.Sqrt(((xx + yy) / 2) + Math.Sqrt((half * half) + (xy * xy)));
        return (longer, longer > 0 ? Math.Abs((ax * by) - (ay * bx)) / longer : 0);
    }

    /// <summary>Dark blue, blue, cyan, white, yellow, red and dark red at 1/64, 1/16, 1/4, 1, 4, 16 and 64 texels, mixed between them.</summary>
    /// <param name="texels">Texels that a sample covers, in area.</param>
    public static Intensity DensityColor(double texels)
    {
        const double most = 64;
        ReadOnlySpan<Intensity> stops = [new(0, 0, 0.25f), new(0, 0, 1), new(0, 1, 1), Intensity.White, new(1, 1, 0), new(1, 0, 0), new(0.25f, 0, 0)];
        double step = (Elementary.Log2(new Double1(Math.Clamp(double.IsNaN(texels) ? 0 : texels, 1 / most, most))).Value / 2) + 3;
        int index = (int)Math.Clamp(step, 0, stops.Length - 2);
        return Intensity.Lerp(stops[index], stops[index + 1], (float)(step - index));
    }

    /// <summary>Dark grey below level 0; then white, red, yellow, green, cyan, blue, violet at levels 0 to 6 and beyond, mixed between them.</summary>
    public static Intensity LevelColor(double level)
    {
        if (!(level >= 0))
        {
            return Intensity.Grey(0.08f);
        }

        ReadOnlySpan<Intensity> stops = [Intensity.White, new(1, 0, 0), new(1, 1, 0), new(0, 1, 0), new(0, 1, 1), new(0, 0, 1), new(0.5f, 0, 1)];
        int index = (int)Math.Min(level, stops.Length - 1);
        return index == stops.Length - 1 ? stops[index] : Intensity.Lerp(stops[index], stops[index + 1], (float)(level - index));
    }
}
