using System.Runtime.CompilerServices;

namespace LabRaytracer;

/// <summary>Looks up packed texels, nearest or bilinear, many points at a time.</summary>
/// <remarks>Bilinear colours are within 6 units of 2^-24 of the largest of the four texels, between exact arithmetic and default lanes.</remarks>
/// <typeparam name="TReader">Reads the store's format.</typeparam>
internal sealed unsafe class PictureSampler<TReader>(
    TexelStore store, float[]? table, TReader reader, SamplingOptions options, TextureFilter filter) : TextureSampler
    where TReader : struct, ITexelReader
{
    public override (TexelAxis Across, TexelAxis Up)? FindAxes(IMapping mapping) => Axes(mapping.DefaultWrapU, mapping.DefaultWrapV);

    public override void Sample<R, F, I>(in LookupBatch<R> lookups, in ColorColumns<F> colors, int packets)
    {
        (TexelAxis across, TexelAxis up) = Axes(lookups.WrapU, lookups.WrapV);
        R* u = lookups.Coordinates.U;
        R* v = lookups.Coordinates.V;
        if (filter == TextureFilter.Nearest)
        {
            for (int packet = 0; packet < packets; packet++)
            {
                R outside = Nearest<R, F, I>(across, up, u[packet], v[packet], out F red, out F green, out F blue);
                Store<R, F, I>(colors, packet, outside, red, green, blue);
            }
        }
        else
        {
            for (int packet = 0; packet < packets; packet++)
            {
                R outside = Bilinear<R, F, I>(across, up, u[packet], v[packet], out F red, out F green, out F blue);
                Store<R, F, I>(colors, packet, outside, red, green, blue);
            }
        }

        // Pinned memory must not be collected while the reader holds raw addresses into it.
        GC.KeepAlive(store);
        GC.KeepAlive(table);
    }

    private (TexelAxis Across, TexelAxis Up) Axes(TextureWrap wrapU, TextureWrap wrapV) =>
        (new(store.Width, options.WrapU ?? wrapU, options.Texels), new(store.Height, options.WrapV ?? wrapV, options.Texels));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private R Nearest<R, F, I>(in TexelAxis across, in TexelAxis up, R u, R v, out F red, out F green, out F blue)
        where R : unmanaged, ILane<R, F, I>
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I>
    {
        R outside = across.Nearest<R, F, I>(u, out I x) | up.Nearest<R, F, I>(v, out I y);
        reader.Read<F, I>(Row(y) + x, out red, out green, out blue);
        return outside;
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private R Bilinear<R, F, I>(in TexelAxis across, in TexelAxis up, R u, R v, out F red, out F green, out F blue)
        where R : unmanaged, ILane<R, F, I>
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I>
    {
        R outside = across.Between<R, F, I>(u, out I x0, out I x1, out F right) | up.Between<R, F, I>(v, out I y0, out I y1, out F above);
        I row0 = Row(y0), row1 = Row(y1);
        Between<F, I>(row0 + x0, row0 + x1, right, out F red0, out F green0, out F blue0);
        Between<F, I>(row1 + x0, row1 + x1, right, out F red1, out F green1, out F blue1);
        red = F.Fma(above, red1 - red0, red0);
        green = F.Fma(above, green1 - green0, green0);
        blue = F.Fma(above, blue1 - blue0, blue0);
        return outside;
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private void Between<F, I>(I first, I second, F weight, out F red, out F green, out F blue)
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I>
    {
        reader.Read<F, I>(first, out F red0, out F green0, out F blue0);
        reader.Read<F, I>(second, out F red1, out F green1, out F blue1);
        red = F.Fma(weight, red1 - red0, red0);
        green = F.Fma(weight, green1 - green0, green0);
        blue = F.Fma(weight, blue1 - blue0, blue0);
    }

    /// <summary>Element number of the first texel of a row; rows go up, the store's go down.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private I Row<I>(I y)
        where I : unmanaged, IIndexLane<I> => I.Of(store.Start) - (y * I.Of(store.Width));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void Store<R, F, I>(in ColorColumns<F> colors, int packet, R outside, F red, F green, F blue)
        where R : unmanaged, ILane<R, F, I>
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I>
    {
        F inside = ~R.MaskToSingle(outside);
        colors.R[packet] = red & inside;
        colors.G[packet] = green & inside;
        colors.B[packet] = blue & inside;
    }
}
