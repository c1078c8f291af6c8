namespace LabRaytracer;

/// <summary>Mapping and texture lookup of a group of hits: each distinct mapping and each distinct texture once, constants never.</summary>
internal static unsafe class TextureStage
{
    /// <summary>Fills the coordinate sets and texel colours that a material reads.</summary>
    public static void Run<R, F, I>(CompiledMaterial material, ShadingBuffers<R, F, I> buffers, int count, WorkerCounters counters)
        where R : unmanaged, ILane<R, F, I>
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I>
    {
        counters.ConstantSlots += (long)count * material.ConstantSlots;
        Run(material.Textures, buffers, count, counters);
    }

    /// <summary>Fills coordinate sets and texel colours.</summary>
    public static void Run<R, F, I>(LookupList material, ShadingBuffers<R, F, I> buffers, int count, WorkerCounters counters)
        where R : unmanaged, ILane<R, F, I>
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I>
    {
        if (material.Lookups.Count == 0)
        {
            return;
        }

        int packets = (count + R.Width - 1) / R.Width;
        for (int set = 0; set < material.Coordinates.Count; set++)
        {
            Map(material.Coordinates[set], buffers.Surfaces.Positions, buffers.Coordinates[set], count, packets);
        }

        bool hasFootprints = buffers.Footprints is not null && material.NeedsFootprints;
        if (hasFootprints)
        {
            FootprintStage.Map(material, buffers, count);
        }

        counters.Mappings += (long)count * material.Coordinates.Count;
        counters.Charge(RenderStage.Map);
        for (int k = 0; k < material.Lookups.Count; k++)
        {
            CompiledLookup lookup = material.Lookups[k];
            if (lookup.Stack is { } stack)
            {
                LayerStage.Run(stack, buffers, k, packets);
                continue;
            }

            LookupBatch<R> lookups = new() { Positions = buffers.Surfaces.Positions, Count = count };
            if (lookup.Coordinates >= 0)
            {
                IMapping mapping = material.Coordinates[lookup.Coordinates].Mapping;
                lookups.Coordinates = buffers.Coordinates[lookup.Coordinates];
                lookups.WrapU = mapping.DefaultWrapU;
                lookups.WrapV = mapping.DefaultWrapV;
            }

            if (hasFootprints && (lookup.Needs & TextureNeeds.Footprint) != 0)
            {
                lookups.Footprints = lookup.Coordinates >= 0 ? buffers.Footprints!.Sets[lookup.Coordinates] : default;
                lookups.LocalFootprints = buffers.Footprints!.Local;
                lookups.WorldFootprints = buffers.Footprints!.World;
            }

            Sample<R, F, I>(lookup.Sampler!, lookups, buffers.Texels[k], packets);
            if (lookup.Alpha >= 0)
            {
                Divide(buffers.Texels[k], buffers.Texels[lookup.Alpha], packets);
            }

            if (lookup.Coordinates >= 0 && material.Coordinates[lookup.Coordinates].Mapping is not IWideMapping)
            {
                MarkLost(lookups.Coordinates, buffers.Texels[k], count);
            }
        }

        counters.TextureLookups += (long)count * material.Lookups.Count;
        counters.Charge(RenderStage.Texture);
    }

    /// <summary>Looks a texture up; the usual samplers are called directly: a virtual generic method is looked up at each call.</summary>
    private static void Sample<R, F, I>(TextureSampler sampler, in LookupBatch<R> lookups, in ColorColumns<F> colors, int packets)
        where R : unmanaged, ILane<R, F, I>
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I>
    {
        switch (sampler)
        {
            case PictureSampler<PackedLinearReader> packed:
                packed.Run<R, F, I>(lookups, colors, packets);
                break;
            case PictureSampler<PackedTableReader> packed:
                packed.Run<R, F, I>(lookups, colors, packets);
                break;
            case PictureSampler<Linear8Reader> linear:
                linear.Run<R, F, I>(lookups, colors, packets);
                break;
            case PictureSampler<Table8Reader> encoded:
                encoded.Run<R, F, I>(lookups, colors, packets);
                break;
            default:
                sampler.Sample<R, F, I>(lookups, colors, packets);
                break;
        }
    }

    /// <summary>Colours that were multiplied by alpha, straight again; black where nothing is there.</summary>
    private static void Divide<F>(in ColorColumns<F> colors, in ColorColumns<F> alpha, int packets)
        where F : unmanaged, IReal<F>
    {
        for (int packet = 0; packet < packets; packet++)
        {
            F share = F.Select(F.Equal(alpha.R[packet], F.Zero), F.Of(1), alpha.R[packet]);
            colors.R[packet] /= share;
            colors.G[packet] /= share;
            colors.B[packet] /= share;
        }
    }

    /// <summary>
    /// Makes the colour NaN where a student's mapping gave coordinates that are not finite: wrapping would hide them, this way the pixel is counted and found.
    /// Built-in mappings are finite for every finite point.
    /// </summary>
    private static void MarkLost<R, F>(in CoordinateBatch<R> coordinates, in ColorColumns<F> colors, int count)
        where R : unmanaged, IReal<R>
        where F : unmanaged, IReal<F>
    {
        for (int i = 0; i < count; i++)
        {
            if (!double.IsFinite(Lane.Take(coordinates.U, i)) || !double.IsFinite(Lane.Take(coordinates.V, i)))
            {
                colors.Put(i, Intensity.Grey(float.NaN));
            }
        }
    }

    /// <summary>Evaluates a mapping and its transform.</summary>
    /// <param name="set">Which.</param>
    /// <param name="positions">Points of the surface.</param>
    /// <param name="coordinates">Receives u and v.</param>
    /// <param name="count">How many points.</param>
    /// <param name="packets">The same in groups of lanes.</param>
    public static void Map<R>(in CompiledCoordinates set, in PositionBatch<R> positions, in CoordinateBatch<R> coordinates, int count, int packets)
        where R : unmanaged, IReal<R>
    {
        // The usual mappings are called directly: a virtual generic method is looked up at each call.
        if (set.Mapping is SphericalMapping)
        {
            PointFormulas.Map<SphericalMapping.Formula, R>(positions, coordinates, packets);
        }
        else if (set.Mapping is RectangularMapping)
        {
            PointFormulas.Map<RectangularMapping.Formula, R>(positions, coordinates, packets);
        }
        else if (set.Mapping is IWideMapping wide)
        {
            wide.Map(positions, coordinates, packets);
        }
        else
        {
            MapEach(set.Mapping, positions, coordinates, count);
        }

        if (set.Around is { } around)
        {
            Unroll(set.Mapping.ClosesU ? coordinates.U : null, around.U, packets);
            Unroll(set.Mapping.ClosesV ? coordinates.V : null, around.V, packets);
        }

        if (!set.Transform.IsIdentity)
        {
            for (int packet = 0; packet < packets; packet++)
            {
                (coordinates.U[packet], coordinates.V[packet]) = set.Transform.Apply(coordinates.U[packet], coordinates.V[packet]);
            }
        }
    }

    /// <summary>Takes whole turns off, so that coordinates lie within half a turn of a place: from half a turn below, included, to half a turn above.</summary>
    private static void Unroll<R>(R* column, double place, int packets)
        where R : unmanaged, IReal<R>
    {
        for (int packet = 0; column != null && packet < packets; packet++)
        {
            column[packet] -= R.Floor(column[packet] - R.Of(place - 0.5));
        }
    }

    /// <summary>A mapping that only knows one point at a time.</summary>
    private static void MapEach<R>(IMapping mapping, in PositionBatch<R> positions, in CoordinateBatch<R> coordinates, int count)
        where R : unmanaged, IReal<R>
    {
        for (int i = 0; i < count; i++)
        {
            TextureCoordinate mapped = mapping.Map(new SurfacePosition(
                new Point3D(Lane.Take(positions.X, i), Lane.Take(positions.Y, i), Lane.Take(positions.Z, i)),
                new Vector3D(Lane.Take(positions.NormalX, i), Lane.Take(positions.NormalY, i), Lane.Take(positions.NormalZ, i)),
                new TextureCoordinate(Lane.Take(positions.SurfaceU, i), Lane.Take(positions.SurfaceV, i)))
            {
                WorldPoint = new Point3D(Lane.Take(positions.WorldX, i), Lane.Take(positions.WorldY, i), Lane.Take(positions.WorldZ, i)),
            });
            Lane.Put(coordinates.U, i, mapped.U);
            Lane.Put(coordinates.V, i, mapped.V);
        }
    }
}
