using System.Runtime.CompilerServices;

namespace LabRaytracer;

/// <summary>Looks up packed texels, nearest or bilinear, many points at a time.</summary>
/// <remarks>Bilinear colours are within 6 units of 2^-24 of the largest of the four texels, between exact arithmetic and default lanes.</remarks>
/// <typeparam name="TReader">Reads the store's format.</typeparam>
/// <param name="store">The texels.</param>
/// <param name="table">What the reader decodes with, kept alive; or null.</param>
/// <param name="reader">Reads them.</param>
/// <param name="options">How the texture is looked up.</param>
/// <param name="filter">Nearest or bilinear.</param>
/// <param name="unpacked">If the reader reads packed texels, bilinear only: makes a sampler that does not, for axes that those do not know.</param>
internal sealed unsafe class PictureSampler<TReader>(
    TexelStore store, float[]? table, TReader reader, SamplingOptions options, TextureFilter filter, Func<TextureSampler>? unpacked = null) : TextureSampler
    where TReader : struct, ITexelReader
{
    private TextureSampler? _unpacked;

    public override (TexelAxis Across, TexelAxis Up)? FindAxes(IMapping mapping) => Axes(mapping.DefaultWrapU, mapping.DefaultWrapV);

    public override void Sample<R, F, I>(in LookupBatch<R> lookups, in ColorColumns<F> colors, int packets) => Run<R, F, I>(lookups, colors, packets);

    /// <summary>The same, not virtual: ahead-of-time compilers do not see through virtual generic methods.</summary>
    [MethodImpl(MethodImplOptions.NoInlining)]
    internal void Run<R, F, I>(in LookupBatch<R> lookups, in ColorColumns<F> colors, int packets)
        where R : unmanaged, ILane<R, F, I>
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I>
    {
        (TexelAxis across, TexelAxis up) = Axes(lookups.WrapU, lookups.WrapV);
        R* u = lookups.Coordinates.U;
        R* v = lookups.Coordinates.V;
        if (unpacked is not null && !(TexelPairs.Fits(across) && TexelPairs.Fits(up)))
        {
            (_unpacked ??= unpacked()).Sample<R, F, I>(lookups, colors, packets);
        }
        else if (filter == TextureFilter.Nearest)
        {
            Nearest<R, F, I>(across, up, u, v, colors, packets);
        }
        else
        {
            Bilinear<R, F, I>(across, up, u, v, colors, packets);
        }

        // Pinned memory must not be collected while the reader holds raw addresses into it.
        GC.KeepAlive(store);
        GC.KeepAlive(table);
    }

    private (TexelAxis Across, TexelAxis Up) Axes(TextureWrap wrapU, TextureWrap wrapV) =>
        (new(store.Width, options.WrapU ?? wrapU, options.Texels), new(store.Height, options.WrapV ?? wrapV, options.Texels));

    /// <summary>Finds the texels of a few groups of lanes, asks the memory for them, then reads them.</summary>
    [SkipLocalsInit]
    private void Nearest<R, F, I>(in TexelAxis across, in TexelAxis up, R* u, R* v, in ColorColumns<F> colors, int packets)
        where R : unmanaged, ILane<R, F, I>
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I>
    {
        const int Packets = BilinearBlock<F, I>.Packets;
        F* memory = stackalloc F[2 * Packets];
        F* inside = memory;
        I* texels = (I*)(memory + Packets);
        for (int first = 0; first < packets; first += Packets)
        {
            int count = Math.Min(packets - first, Packets);
            for (int k = 0; k < count; k++)
            {
                R outside = across.Nearest<R, F, I>(u[first + k], out I x) | up.Nearest<R, F, I>(v[first + k], out I y);
                inside[k] = ~R.MaskToSingle(outside);
                texels[k] = Row(y) + x;
            }

            for (int k = 0; k < count * I.Width && store.IsLarge; k++)
            {
                reader.Prefetch(((int*)texels)[k]);
            }

            for (int k = 0; k < count; k++)
            {
                reader.Read<F, I>(texels[k], out F red, out F green, out F blue);
                colors.R[first + k] = red & inside[k];
                colors.G[first + k] = green & inside[k];
                colors.B[first + k] = blue & inside[k];
            }
        }
    }

    [SkipLocalsInit]
    private void Bilinear<R, F, I>(in TexelAxis across, in TexelAxis up, R* u, R* v, in ColorColumns<F> colors, int packets)
        where R : unmanaged, ILane<R, F, I>
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I>
    {
        const int Packets = BilinearBlock<F, I>.Packets;
        F* memory = stackalloc F[2 * BilinearBlock<F, I>.Size];
        BilinearBlock<F, I> block = new(memory), next = new(memory + BilinearBlock<F, I>.Size);
        bool isUsual = TexelPairs.Fits(across) && TexelPairs.Fits(up);
        int count = Math.Min(packets, Packets);
        Locate<R, F, I>(across, up, isUsual, u, v, block, count);
        for (int k = 0; k < count && store.IsLarge; k++)
        {
            Prefetch(block, k);
        }

        for (int first = 0; first < packets; first += Packets)
        {
            int ahead = Math.Clamp(packets - first - Packets, 0, Packets);
            Locate<R, F, I>(across, up, isUsual, u + first + Packets, v + first + Packets, next, ahead);
            for (int k = 0; k < count; k++)
            {
                if (k < ahead && store.IsLarge)
                {
                    Prefetch(next, k);
                }

                Mix(block, k, colors, first + k);
            }

            (block, next, count) = (next, block, ahead);
        }
    }

    /// <summary>Finds the texels of some groups of lanes.</summary>
    private void Locate<R, F, I>(in TexelAxis across, in TexelAxis up, bool isUsual, R* u, R* v, in BilinearBlock<F, I> block, int count)
        where R : unmanaged, ILane<R, F, I>
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I>
    {
        if (isUsual)
        {
            LocateUsual<R, F, I>(across, up, u, v, block, count);
        }

        for (int k = 0; k < count && !isUsual; k++)
        {
            Locate<R, F, I>(across, up, u[k], v[k], block, k);
        }
    }

    /// <summary>The same on usual axes.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private void LocateUsual<R, F, I>(in TexelAxis across, in TexelAxis up, R* u, R* v, in BilinearBlock<F, I> block, int count)
        where R : unmanaged, ILane<R, F, I>
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I>
    {
        if (unpacked is null)
        {
            TexelPairs.Locate<R, F, I>(across, up, store.Start, u, v, block, count);
        }
        else
        {
            PackedPairs.Locate<R, F, I>(store.Packed!, across, up, u, v, block, count);
        }
    }

    /// <summary>Finds the texels of one group of lanes.</summary>
    private void Locate<R, F, I>(in TexelAxis across, in TexelAxis up, R u, R v, in BilinearBlock<F, I> block, int k)
        where R : unmanaged, ILane<R, F, I>
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I>
    {
        R outside = across.Between<R, F, I>(u, out I x0, out I x1, out block.WeightRight[k]);
        outside |= up.Between<R, F, I>(v, out I y0, out I y1, out block.WeightAbove[k]);
        block.Inside[k] = ~R.MaskToSingle(outside);
        block.Below[k] = Row(y0) + x0;
        block.Above[k] = Row(y1) + x0;
        block.Across[k] = x1 - x0;
    }

    /// <summary>Asks the memory for the texels of one group of lanes.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private void Prefetch<F, I>(in BilinearBlock<F, I> block, int k)
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I>
    {
        int* below = (int*)(block.Below + k), above = (int*)(block.Above + k);
        for (int lane = 0; lane < I.Width; lane++)
        {
            reader.Prefetch(below[lane]);
            reader.Prefetch(above[lane]);
        }
    }

    /// <summary>Mixes the four texels of each lane.</summary>
    [MethodImpl(MethodImplOptions.NoInlining)]
    private void Mix<F, I>(in BilinearBlock<F, I> block, int k, in ColorColumns<F> colors, int packet)
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I>
    {
        bool areNeighbors = I.AllEqual(block.Across[k], 1);
        Row(block.Below + k, areNeighbors, block, k, out F red, out F green, out F blue);
        Row(block.Above + k, areNeighbors, block, k, out F red1, out F green1, out F blue1);
        F above = block.WeightAbove[k], inside = block.Inside[k];
        colors.R[packet] = F.Fma(above, red1 - red, red) & inside;
        colors.G[packet] = F.Fma(above, green1 - green, green) & inside;
        colors.B[packet] = F.Fma(above, blue1 - blue, blue) & inside;
    }

    /// <summary>Mixes the two texels of one row.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private void Row<F, I>(I* texel, bool areNeighbors, in BilinearBlock<F, I> block, int k, out F red, out F green, out F blue)
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I>
    {
        F red1, green1, blue1;
        if (areNeighbors)
        {
            reader.ReadPair(texel, out red, out green, out blue, out red1, out green1, out blue1);
        }
        else
        {
            reader.Read(*texel, out red, out green, out blue);
            reader.Read(*texel + block.Across[k], out red1, out green1, out blue1);
        }

        F right = block.WeightRight[k];
        red = F.Fma(right, red1 - red, red);
        green = F.Fma(right, green1 - green, green);
        blue = F.Fma(right, blue1 - blue, blue);
    }

    /// <summary>Element number of the first texel of a row; rows go up, the store's go down.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private I Row<I>(I y)
        where I : unmanaged, IIndexLane<I> => I.Of(store.Start) - (y * I.Of(store.Width));
}
