namespace LabRaytracer;

/// <summary>Looks up packed texels by a cubic kernel of 4 x 4 texels, many points at a time.</summary>
/// <typeparam name="TReader">Reads the store's format.</typeparam>
/// <remarks>Within 24 units of 2^-24 of the largest of the sixteen texels, between exact arithmetic and default lanes.</remarks>
internal sealed unsafe class BicubicSampler<TReader>(
    TexelStore store, float[]? table, TReader reader, SamplingOptions options, TextureFilter filter, bool isData) : TextureSampler
    where TReader : struct, ITexelReader
{
    public override (TexelAxis Across, TexelAxis Up)? FindAxes(IMapping mapping) => Axes(mapping.DefaultWrapU, mapping.DefaultWrapV);

    public override void Sample<R, F, I>(in LookupBatch<R> lookups, in ColorColumns<F> colors, int packets)
    {
        (TexelAxis across, TexelAxis up) = Axes(lookups.WrapU, lookups.WrapV);
        BicubicKernel<TReader> kernel = new(reader, store.Start, store.Width, BicubicKernel<TReader>.Bounds(filter, isData));
        for (int packet = 0; packet < packets; packet++)
        {
            R outside = across.Around(lookups.Coordinates.U[packet], filter, out CubicTaps<F, I> columns)
                | up.Around(lookups.Coordinates.V[packet], filter, out CubicTaps<F, I> rows);
            kernel.Mean(columns, rows, out CubicColor<F> mean);
            F inside = ~R.MaskToSingle(outside);
            colors.R[packet] = mean.R & inside;
            colors.G[packet] = mean.G & inside;
            colors.B[packet] = mean.B & inside;
        }

        // Pinned memory must not be collected while the reader holds raw addresses into it.
        GC.KeepAlive(store);
        GC.KeepAlive(table);
    }

    private (TexelAxis Across, TexelAxis Up) Axes(TextureWrap wrapU, TextureWrap wrapV) =>
        (new(store.Width, options.WrapU ?? wrapU, options.Texels), new(store.Height, options.WrapV ?? wrapV, options.Texels));
}
