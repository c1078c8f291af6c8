namespace LabRaytracer;

/// <summary>Looks up a triplanar texture, many points at a time.</summary>
internal sealed unsafe class TriplanarSampler(TriplanarTexture texture, TextureSampler source) : TextureSampler
{
    protected override IReadOnlyList<TextureSampler> Sources => [source];

    public override void Sample<R, F, I>(in LookupBatch<R> lookups, in ColorColumns<F> colors, int packets)
    {
        const int chunk = TextureParts.Chunk;
        R* coordinates = stackalloc R[2 * chunk];
        F* memory = stackalloc F[8 * chunk];
        ColorColumns<F> texels = TextureParts.Columns(memory);
        for (int start = 0; start < packets; start += chunk)
        {
            int count = Math.Min(chunk, packets - start);
            LookupBatch<R> part = lookups.Part(start, count);
            ColorColumns<F> sum = new() { R = colors.R + start, G = colors.G + start, B = colors.B + start };
            new Span<F>(sum.R, count).Clear();
            new Span<F>(sum.G, count).Clear();
            new Span<F>(sum.B, count).Clear();
            for (int axis = 0; axis < 3; axis++)
            {
                Project<R, F, I>(part, sum, texels, coordinates, memory + (3 * chunk), axis, count);
            }
        }
    }

    private void Project<R, F, I>(
        in LookupBatch<R> part, in ColorColumns<F> sum, in ColorColumns<F> texels, R* coordinates, F* memory, int axis, int count)
        where R : unmanaged, ILane<R, F, I>
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I>
    {
        const int chunk = TextureParts.Chunk;
        F* weights = memory;
        LocalFootprintColumns steps = part.LocalFootprints;
        FootprintColumns footprints = steps.XDx == null ? default : new FootprintColumns((float*)(memory + chunk), chunk * F.Width);
        PositionBatch<R> at = part.Positions;
        F any = F.Zero;
        for (int i = 0; i < count; i++)
        {
            TriplanarPlanes<R, F, I> planes = new(texture, at.X[i], at.Y[i], at.Z[i], at.NormalX[i], at.NormalY[i], at.NormalZ[i]);
            weights[i] = planes.Weight(axis);
            any |= F.Less(F.Zero, weights[i]);
            (coordinates[i], coordinates[chunk + i]) = planes.Coordinates(axis);
            if (steps.XDx != null)
            {
                (((F*)footprints.DuDx)[i], ((F*)footprints.DvDx)[i]) = planes.Step(axis, ((F*)steps.XDx)[i], ((F*)steps.YDx)[i], ((F*)steps.ZDx)[i]);
                (((F*)footprints.DuDy)[i], ((F*)footprints.DvDy)[i]) = planes.Step(axis, ((F*)steps.XDy)[i], ((F*)steps.YDy)[i], ((F*)steps.ZDy)[i]);
            }
        }

        if (!F.Any(any))
        {
            return;
        }

        LookupBatch<R> projected = part with
        {
            Coordinates = new CoordinateBatch<R> { U = coordinates, V = coordinates + chunk },
            Footprints = footprints,
            WrapU = TextureWrap.Repeat,
            WrapV = TextureWrap.Repeat,
        };
        source.Sample<R, F, I>(projected, texels, count);
        for (int i = 0; i < count; i++)
        {
            F seen = F.Less(F.Zero, weights[i]);
            sum.R[i] = F.Select(seen, F.Fma(weights[i], texels.R[i], sum.R[i]), sum.R[i]);
            sum.G[i] = F.Select(seen, F.Fma(weights[i], texels.G[i], sum.G[i]), sum.G[i]);
            sum.B[i] = F.Select(seen, F.Fma(weights[i], texels.B[i], sum.B[i]), sum.B[i]);
        }
    }
}
