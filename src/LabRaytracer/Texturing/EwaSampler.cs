using System.Numerics;
using System.Runtime.CompilerServices;

namespace LabRaytracer;

/// <summary>A weighted mean of the texels inside the footprint: what is called EWA (Greene and Heckbert 1986), with the parallelogram of the pixel in place of an ellipse.</summary>
/// <typeparam name="TReader">Reads the store's format.</typeparam>
/// <remarks>
/// <para>Pixels are squares, whose footprints are parallelograms; their ellipses give errors more than twice as large (docs/filtering.md). See <see cref="EwaKernel"/> for the weights.</para>
/// <para>The level is the smallest of the pyramid whose texels are not larger than half the shorter axis of the footprint if that is at least an eighth of the longer axis, than the
/// shorter axis if it is at most a sixteenth, than a sixteenth of the longer axis between: texels as large as the footprint blur it as much again, half as large a fifth as much, and
/// short footprints can afford it. The shorter axis counts as at least 1/64 of the longer one. So a footprint is at most 32 texels long if it is up to sixteen times as long as wide,
/// and 2 wide and 128 long at most, plus the reach of its weights: at most 264 rows, of which a sample reads a few texels each.</para>
/// <para>Footprints not longer than a texel are bilinear; up to twice as long, a mix of both.</para>
/// <para>The sums run over blocks of four texels of two rows, the same on every machine.</para>
/// </remarks>
internal sealed unsafe class EwaSampler<TReader>(
    TexelStore store, float[]? table, TReader reader, SamplingOptions options, MipPyramid pyramid) : MipSampler<TReader>(store, table, reader, options, pyramid)
    where TReader : struct, ITexelReader
{
    /// <summary>Texels beside the levels that are there once more: as many as reach out of a level with a footprint up to sixteen times as long as wide.</summary>
    public const int Margin = 40;

    [SkipLocalsInit]
    protected override void Filter<R, F, I>(in LookupBatch<R> lookups, in TexelAxis across, in TexelAxis up, in ColorColumns<F> colors, int packets)
    {
        F* sizes = stackalloc F[(1 + EwaSides<F>.Size) * packets], all = sizes + packets;
        for (int packet = 0; packet < packets; packet++)
        {
            EwaSides<F> sides = new(all + (EwaSides<F>.Size * packet));
            sides.Read(lookups.Footprints, across, up, packet);
            sizes[packet] = sides.LongerSquare;
        }

        Enlarge<R, F, I>(lookups, colors, sizes, 4, packets);
        F* memory = stackalloc F[2 * EwaGroup<F>.Size];
        EwaGroup<F> group = new(memory), next = new(memory + EwaGroup<F>.Size);
        int fallbacks = 0, last = -1;
        for (int packet = 0; packet < packets; packet++)
        {
            if (F.Any(F.Less(F.Of(1), sizes[packet])))
            {
                fallbacks += Prepare<R, F, I>(lookups, across, up, packet, new(all + (EwaSides<F>.Size * packet)), next);
                if (last >= 0)
                {
                    Average<F, I>(group, next, across.Wrap, up.Wrap, colors, last);
                }

                (group, next, last) = (next, group, packet);
            }
        }

        if (last >= 0)
        {
            *next.IsInner = F.Zero;
            Average<F, I>(group, next, across.Wrap, up.Wrap, colors, last);
        }

        CountFallbacks(fallbacks);
    }

    /// <summary>Finds out what there is to read of the footprints of a group of lanes, where they are larger than a texel.</summary>
    /// <returns>How many were too long.</returns>
    [MethodImpl(MethodImplOptions.NoInlining)]
    private int Prepare<R, F, I>(in LookupBatch<R> lookups, in TexelAxis across, in TexelAxis up, int packet, EwaSides<F> sides, EwaGroup<F> group)
        where R : unmanaged, ILane<R, F, I>
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I>
    {
        R u = lookups.Coordinates.U[packet], v = lookups.Coordinates.V[packet];
        F isLarge = F.Less(F.Of(1), sides.LongerSquare) & ~R.MaskToSingle(across.Outside(u) | up.Outside(v));
        F level = F.Select(isLarge, sides.Level(Pyramid.LevelCount - 1, out F isTooLong), F.Zero);
        Require(level, isLarge);

        I number = F.ToInt32(level);
        MipLevels.Find(Pyramid, number, out I width, out I height, out I start, out I stride);
        F columns = F.FromInt32(width), rows = F.FromInt32(height);
        R x = R.Fma(Place(across, u), R.FromSingle(columns), R.Of(-0.5)), y = R.Fma(Place(up, v), R.FromSingle(rows), R.Of(-0.5)), left = R.Floor(x), below = R.Floor(y);
        F* kernels = group.Kernels;
        sides.Store(columns / F.Of(across.Size), rows / F.Of(up.Size), R.ToSingle(x - left), R.ToSingle(y - below), kernels);
        I column = R.ToInt32(left), row = R.ToInt32(below);
        EwaPlace.Store(number, start, stride, column, row, group.Places);
        I isBetween = EwaPlace.IsInside(column, width, F.ToInt32(kernels[EwaKernel.ReachXNumber]), across.Wrap == TextureWrap.Repeat ? Pyramid.Margin : 0);
        F isInner = F.MaskFromInt32(isBetween & EwaPlace.IsInside(row, height, F.ToInt32(kernels[EwaKernel.ReachYNumber]), up.Wrap == TextureWrap.Repeat ? Pyramid.Margin : 0));
        *group.IsLarge = isLarge;
        *group.IsInner = isLarge & (Pyramid.HasPicture ? isInner : isInner & F.LessOrEqual(F.Of(1), level));
        *group.Share = F.Min((sides.LongerSquare - F.Of(1)) * F.Of(1.0 / 3), F.Of(1));
        EwaRows.Find<F, I>(kernels, group.Rows, 0, Math.Min(EwaRows.Begin<F, I>(kernels, isLarge, group.Rows), EwaRows.Pairs));
        return BitOperations.PopCount(F.Bits(isTooLong & isLarge));
    }

    /// <summary>Averages over the footprints of a group of lanes.</summary>
    /// <param name="group">The group.</param>
    /// <param name="next">The next one, whose texels the memory is asked for.</param>
    /// <param name="wrapU">What lies beyond the columns.</param>
    /// <param name="wrapV">What lies beyond the rows.</param>
    /// <param name="colors">Where the colours go.</param>
    /// <param name="packet">Number of the group.</param>
    [SkipLocalsInit]
    [MethodImpl(MethodImplOptions.NoInlining)]
    private void Average<F, I>(EwaGroup<F> group, EwaGroup<F> next, TextureWrap wrapU, TextureWrap wrapV, in ColorColumns<F> colors, int packet)
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I>
    {
        Float4* means = stackalloc Float4[Math.Max(F.Width, 4)];
        uint open = F.Bits(*group.IsLarge), inner = F.Bits(*group.IsInner), ahead = F.Bits(*next.IsInner);
        for (uint lanes = open | ahead; lanes != 0; lanes &= lanes - 1)
        {
            int lane = BitOperations.TrailingZeroCount(lanes);
            if ((ahead >> lane & 1) != 0)
            {
                Prefetch<F>(next.Places + lane, (float*)next.Rows + lane);
            }

            if ((open >> lane & 1) != 0)
            {
                means[lane] = Sum(group, lane, wrapU, wrapV, (inner >> lane & 1) != 0, 0);
            }
        }

        int pairs = (int)F.Largest(F.FromInt32(I.Load((int*)(group.Rows + 1))));
        for (int first = EwaRows.Pairs; first < pairs; first += EwaRows.Pairs)
        {
            EwaRows.Find<F, I>(group.Kernels, group.Rows, first, Math.Min(pairs - first, EwaRows.Pairs));
            for (uint lanes = open; lanes != 0; lanes &= lanes - 1)
            {
                int lane = BitOperations.TrailingZeroCount(lanes);
                if (((int*)(group.Rows + 1))[lane] > first)
                {
                    means[lane] += Sum(group, lane, wrapU, wrapV, (inner >> lane & 1) != 0, first);
                }
            }
        }

        LaneTriples.Turn(means, out F red, out F green, out F blue, out F weight);
        (red, green, blue) = (red / weight, green / weight, blue / weight);
        F isLarge = *group.IsLarge, share = *group.Share, isWhole = F.LessOrEqual(F.Of(1), share);
        Mix(ref colors.R[packet], red, share, isWhole, isLarge);
        Mix(ref colors.G[packet], green, share, isWhole, isLarge);
        Mix(ref colors.B[packet], blue, share, isWhole, isLarge);
    }

    /// <summary>Between a bilinear colour and the mean of a footprint.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void Mix<F>(ref F color, F mean, F share, F isWhole, F isLarge)
        where F : unmanaged, IReal<F> =>
        color = F.Select(isLarge, F.Select(isWhole, mean, color + ((mean - color) * share)), color);

    /// <summary>Makes sure that the levels of some lanes are there.</summary>
    private void Require<F>(F level, F isRead)
        where F : unmanaged, IReal<F>
    {
        int last = (int)F.Largest(F.Select(isRead, level, F.Zero)), first = 1;
        Pyramid.Require(last, Threads);
        if (Pyramid.HasPicture && F.Any(isRead & F.Less(level, F.Of(1))))
        {
            Pyramid.RequirePicture();
            first = 0;
        }

        Pyramid.Grey.Require(first, last);
    }

    /// <summary>Asks the memory for the first texels of a lookup that will soon be summed: they lie far apart.</summary>
    [MethodImpl(MethodImplOptions.NoInlining)]
    private void Prefetch<F>(int* places, float* rows)
        where F : unmanaged, IReal<F>
    {
        EwaPlace place = new(places, F.Width);
        bool isGrey = Pyramid.Grey.Has(place.Level);
        nint channels = isGrey ? 1 : MipPyramid.Channels, stride = channels * place.Stride;
        float* row = (isGrey ? Pyramid.Grey.Texels : Pyramid.Texels) + (channels * place.Texel) + (((int*)rows)[0] * stride), pair = rows + (EwaRows.Lead * F.Width);
        for (int pairs = Math.Min(((int*)rows)[F.Width], EwaRows.Pairs); pairs > 0; pairs--)
        {
            float* block = row + (channels * ((int*)pair)[0]);
            for (int count = ((int*)pair)[F.Width]; count > 0; count--)
            {
                CacheLine.Prefetch(block);
                CacheLine.Prefetch(block + stride);
                block += 4 * channels;
            }

            row += 2 * stride;
            pair += EwaRows.PairNumbers * F.Width;
        }
    }

    /// <summary>The sum over some pairs of rows of one lookup: red, green, blue, and the sum of the weights.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private Float4 Sum<F>(EwaGroup<F> group, int lane, TextureWrap wrapU, TextureWrap wrapV, bool isInner, int first)
        where F : unmanaged, IReal<F>
    {
        EwaPlace place = new(group.Places + lane, F.Width);
        float* kernel = (float*)group.Kernels + lane, rows = (float*)group.Rows + lane;
        if (!isInner)
        {
            return OuterSum<F>(place, wrapU, wrapV, kernel, rows, first);
        }

        bool isStraight = new EwaKernel(kernel, F.Width).Skew == 0;
        if (Pyramid.Grey.Has(place.Level))
        {
            EwaGreyBlocks grey = new(Pyramid.Grey.Texels + place.Texel, place.Stride);
            return isStraight ? EwaSums.Sum<EwaGreyBlocks, Straight, F>(grey, kernel, rows, first) : EwaSums.Sum<EwaGreyBlocks, Skewed, F>(grey, kernel, rows, first);
        }

        EwaInnerBlocks inner = new(Pyramid.Texels + (MipPyramid.Channels * (nint)place.Texel), MipPyramid.Channels * place.Stride);
        return isStraight ? EwaSums.Sum<EwaInnerBlocks, Straight, F>(inner, kernel, rows, first) : EwaSums.Sum<EwaInnerBlocks, Skewed, F>(inner, kernel, rows, first);
    }

    [MethodImpl(MethodImplOptions.NoInlining)]
    private Float4 OuterSum<F>(EwaPlace place, TextureWrap wrapU, TextureWrap wrapV, float* kernel, float* rows, int first)
        where F : unmanaged, IReal<F>
    {
        EwaLevel texels = new(Pyramid, place.Level, Start, wrapU, wrapV);
        if (place.Level == 0 && !Pyramid.HasPicture)
        {
            return EwaSums.Sum<EwaPackedBlocks<TReader>, Skewed, F>(new EwaPackedBlocks<TReader>(texels, Reader, place.Column, place.Row), kernel, rows, first);
        }

        EwaOuterBlocks outer = new(texels, Pyramid, place.Column, place.Row);
        return new EwaKernel(kernel, F.Width).Skew == 0
            ? EwaSums.Sum<EwaOuterBlocks, Straight, F>(outer, kernel, rows, first)
            : EwaSums.Sum<EwaOuterBlocks, Skewed, F>(outer, kernel, rows, first);
    }
}
