namespace LabRaytracer;

/// <summary>Looks up a picture filtered over the footprints of samples; where they are points, or as small as a texel, bilinear.</summary>
/// <typeparam name="TReader">Reads the store's format.</typeparam>
internal abstract unsafe class MipSampler<TReader>(
    TexelStore store, float[]? table, TReader reader, SamplingOptions options, MipPyramid pyramid) : TextureSampler
    where TReader : struct, ITexelReader
{
    private readonly PictureSampler<TReader> _bilinear = new(store, table, reader, options, TextureFilter.Bilinear);

    /// <summary>Reads level 0.</summary>
    protected TReader Reader => reader;

    /// <summary>Element number of the bottom-left texel of level 0.</summary>
    protected int Start => store.Start;

    /// <summary>The levels.</summary>
    protected MipPyramid Pyramid => pyramid;

    public sealed override (TexelAxis Across, TexelAxis Up)? FindAxes(IMapping mapping) => _bilinear.FindAxes(mapping);

    public sealed override void Sample<R, F, I>(in LookupBatch<R> lookups, in ColorColumns<F> colors, int packets)
    {
        if (lookups.Footprints.DuDx == null || pyramid.LevelCount == 1)
        {
            _bilinear.Run<R, F, I>(lookups, colors, packets);
        }
        else
        {
            TexelAxis across = new(store.Width, options.WrapU ?? lookups.WrapU, options.Texels), up = new(store.Height, options.WrapV ?? lookups.WrapV, options.Texels);
            Filter<R, F, I>(lookups, across, up, colors, packets);
        }

        // Pinned memory must not be collected while the reader holds raw addresses into it.
        GC.KeepAlive(store);
        GC.KeepAlive(table);
        GC.KeepAlive(pyramid);
    }

    /// <summary>Looks up a batch.</summary>
    /// <param name="lookups">Where, with footprints.</param>
    /// <param name="across">Columns of the picture.</param>
    /// <param name="up">Rows of the picture.</param>
    /// <param name="colors">Where the colours go.</param>
    /// <param name="packets">Groups of lanes.</param>
    protected abstract void Filter<R, F, I>(in LookupBatch<R> lookups, in TexelAxis across, in TexelAxis up, in ColorColumns<F> colors, int packets)
        where R : unmanaged, ILane<R, F, I>
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I>;

    /// <summary>Bilinear colours of the groups of lanes in which some size is not above a limit, or no number; black of the others, for what lies outside of a border.</summary>
    protected void Enlarge<R, F, I>(in LookupBatch<R> lookups, in ColorColumns<F> colors, F* sizes, double limit, int packets)
        where R : unmanaged, ILane<R, F, I>
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I>
    {
        for (int first = 0; first < packets;)
        {
            int end = first;
            while (end < packets && F.Any(~F.LessOrEqual(F.Of(limit), sizes[end])))
            {
                end++;
            }

            if (end > first)
            {
                LookupBatch<R> part = lookups;
                part.Coordinates.U += first;
                part.Coordinates.V += first;
                ColorColumns<F> to = new() { R = colors.R + first, G = colors.G + first, B = colors.B + first };
                _bilinear.Run<R, F, I>(part, to, end - first);
            }

            if (end < packets)
            {
                colors.R[end] = colors.G[end] = colors.B[end] = F.Zero;
            }

            first = end + 1;
        }
    }

    /// <summary>A coordinate in [0, 1] of which the picture covers all, whatever the convention: texel centres at (x + 1/2) / size.</summary>
    protected static R Place<R>(in TexelAxis axis, R coordinate)
        where R : unmanaged, IReal<R>
    {
        R inside = axis.Wrapped(coordinate);
        return axis.Texels == TexelConvention.Lab
            ? R.Fma(inside, R.Of((axis.Size - 1.0) / axis.Size), R.Of(0.5 / axis.Size))
            : inside;
    }
}
