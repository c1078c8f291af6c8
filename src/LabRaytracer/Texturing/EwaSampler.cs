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
    /// <summary>The most that the longer axis of a footprint may be of the shorter one.</summary>
    public const int MaxAnisotropy = 64;

    [SkipLocalsInit]
    protected override void Filter<R, F, I>(in LookupBatch<R> lookups, in TexelAxis across, in TexelAxis up, in ColorColumns<F> colors, int packets)
    {
        F* sizes = stackalloc F[packets];
        for (int packet = 0; packet < packets; packet++)
        {
            Sides<F> sides = new(lookups.Footprints, across, up, packet);
            sizes[packet] = sides.LongerSquare;
        }

        Enlarge<R, F, I>(lookups, colors, sizes, 4, packets);
        int fallbacks = 0;
        for (int packet = 0; packet < packets; packet++)
        {
            if (F.Any(F.Less(F.Of(1), sizes[packet])))
            {
                fallbacks += Average<R, F, I>(lookups, across, up, colors, packet);
            }
        }

        CountFallbacks(fallbacks);
    }

    /// <summary>Averages over the footprints of a group of lanes, where they are larger than a texel.</summary>
    /// <returns>How many were too long.</returns>
    [SkipLocalsInit]
    [MethodImpl(MethodImplOptions.NoInlining)]
    private int Average<R, F, I>(in LookupBatch<R> lookups, in TexelAxis across, in TexelAxis up, in ColorColumns<F> colors, int packet)
        where R : unmanaged, ILane<R, F, I>
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I>
    {
        Sides<F> sides = new(lookups.Footprints, across, up, packet);
        R u = lookups.Coordinates.U[packet], v = lookups.Coordinates.V[packet];
        F isLarge = F.Less(F.Of(1), sides.LongerSquare) & ~R.MaskToSingle(across.Outside(u) | up.Outside(v));
        F level = sides.Level(Pyramid.LevelCount - 1, out F isTooLong);
        Require(level, isLarge);

        I number = F.ToInt32(level), width = I.Gather(Pyramid.Widths, number), height = I.Gather(Pyramid.Heights, number);
        F columns = F.FromInt32(width), rows = F.FromInt32(height);
        R x = R.Fma(Place(across, u), R.FromSingle(columns), R.Of(-0.5)), y = R.Fma(Place(up, v), R.FromSingle(rows), R.Of(-0.5)), left = R.Floor(x), below = R.Floor(y);
        F* kernels = stackalloc F[EwaKernel.Numbers];
        sides.Store(columns, rows, R.ToSingle(x - left), R.ToSingle(y - below), kernels);
        I column = R.ToInt32(left), row = R.ToInt32(below);
        int* places = stackalloc int[EwaPlace.Numbers * F.Width];
        EwaPlace.Store(Pyramid, number, column, row, places);
        F isInner = F.MaskFromInt32(EwaPlace.IsInside(column, width, F.ToInt32(kernels[EwaKernel.ReachXNumber])) & EwaPlace.IsInside(row, height, F.ToInt32(kernels[EwaKernel.ReachYNumber])));
        isInner = Pyramid.HasPicture ? isInner : isInner & F.LessOrEqual(F.Of(1), level);
        Float4* means = stackalloc Float4[Math.Max(F.Width, 4)];
        uint inner = F.Bits(isInner);
        for (uint open = F.Bits(isLarge); open != 0; open &= open - 1)
        {
            int lane = BitOperations.TrailingZeroCount(open), next = BitOperations.TrailingZeroCount(open & (open - 1));
            if (next < F.Width && (inner >> next & 1) != 0)
            {
                Prefetch(new EwaPlace(places + next, F.Width), new EwaKernel((float*)kernels + next, F.Width));
            }

            means[lane] = Mean(new EwaPlace(places + lane, F.Width), across.Wrap, up.Wrap, new EwaKernel((float*)kernels + lane, F.Width), (inner >> lane & 1) != 0);
        }

        LaneTriples.Turn(means, out F red, out F green, out F blue);
        F share = F.Min((sides.LongerSquare - F.Of(1)) * F.Of(1.0 / 3), F.Of(1)), isWhole = F.LessOrEqual(F.Of(1), share);
        Mix(ref colors.R[packet], red, share, isWhole, isLarge);
        Mix(ref colors.G[packet], green, share, isWhole, isLarge);
        Mix(ref colors.B[packet], blue, share, isWhole, isLarge);
        return BitOperations.PopCount(F.Bits(isTooLong & isLarge));
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
        Pyramid.Require((int)F.Largest(F.Select(isRead, level, F.Zero)), Threads);
        if (Pyramid.HasPicture && F.Any(isRead & F.Less(level, F.Of(1))))
        {
            Pyramid.RequirePicture();
        }
    }

    /// <summary>Asks the memory for the texels of the next lookup, whose rows lie far apart.</summary>
    [MethodImpl(MethodImplOptions.NoInlining)]
    private void Prefetch(EwaPlace place, EwaKernel kernel)
    {
        nint stride = MipPyramid.Channels * place.Stride;
        int reach = (int)kernel.ReachY;
        float* row = Pyramid.Texels + (MipPyramid.Channels * (nint)place.Texel) - (reach * stride);
        float step = kernel.Slant * MipPyramid.Channels, x = -reach * step;
        for (int y = -reach; y <= reach + 1; y++)
        {
            CacheLine.Prefetch(row + float.ConvertToIntegerNative<int>(x));
            row += stride;
            x += step;
        }
    }

    /// <summary>The mean over one footprint: red, green, blue, 1.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private Float4 Mean(EwaPlace place, TextureWrap wrapU, TextureWrap wrapV, EwaKernel kernel, bool isInner)
    {
        if (!isInner)
        {
            return OuterMean(place, wrapU, wrapV, kernel);
        }

        EwaInnerBlocks inner = new(Pyramid.Texels + (MipPyramid.Channels * (nint)place.Texel), MipPyramid.Channels * place.Stride);
        return kernel.Skew == 0 ? Sum<EwaInnerBlocks, Straight>(ref inner, kernel) : Sum<EwaInnerBlocks, Skewed>(ref inner, kernel);
    }

    [MethodImpl(MethodImplOptions.NoInlining)]
    private Float4 OuterMean(EwaPlace place, TextureWrap wrapU, TextureWrap wrapV, EwaKernel kernel)
    {
        EwaLevel texels = new(Pyramid, place.Level, Start, wrapU, wrapV);
        if (place.Level == 0 && !Pyramid.HasPicture)
        {
            EwaPackedBlocks<TReader> packed = new(texels, Reader, place.Column, place.Row);
            return Sum<EwaPackedBlocks<TReader>, Skewed>(ref packed, kernel);
        }

        EwaOuterBlocks outer = new(texels, Pyramid, place.Column, place.Row);
        return kernel.Skew == 0 ? Sum<EwaOuterBlocks, Straight>(ref outer, kernel) : Sum<EwaOuterBlocks, Skewed>(ref outer, kernel);
    }

    /// <summary>The mean of texels by their weights.</summary>
    [SkipLocalsInit]
    [MethodImpl(MethodImplOptions.NoInlining)]
    private static Float4 Sum<TBlocks, TWeights>(ref TBlocks blocks, EwaKernel kernel)
        where TBlocks : struct, IEwaBlocks
        where TWeights : struct, IEwaWeights
    {
        Float8 one = Float8.Of(1f), columns = Float8.Join(Float4.Iota(0), Float4.Iota(0)), rows = Float8.Join(Float4.Zero, Float4.Of(1));
        Float8 blockS = Float8.Fma(columns, Float8.Of(kernel.SX), rows * Float8.Of(kernel.SY)), blockT = Float8.Fma(columns, Float8.Of(kernel.TX), rows * Float8.Of(kernel.TY));
        Float8 endS = Float8.Of(kernel.SEnd), endT = Float8.Of(kernel.TEnd), even = Float8.Zero, odd = Float8.Zero;
        float sx = kernel.SX, tx = kernel.TX, sy = kernel.SY, ty = kernel.TY, skew = kernel.Skew, slant = kernel.Slant, reach = kernel.Reach;
        float cx = kernel.CenterX, cy = kernel.CenterY, left = cx - kernel.ReachX, right = cx + kernel.ReachX, bottom = MathF.Ceiling(cy - kernel.ReachY);
        int pairs = float.ConvertToIntegerNative<int>((cy + kernel.ReachY - bottom) * 0.5f) + 1;
        int* counts = stackalloc int[Float8.Width];
        float* starts = stackalloc float[4 * Float8.Width];

        // Rows and columns are whole numbers, a few hundred at most, exact as floats. Those of eight pairs of rows are found at once: the processor guesses how many blocks
        // a pair has, and a wrong guess costs less where the number is known early.
        for (int first = 0; first < pairs; first += Float8.Width)
        {
            Float8 y = Float8.Fma(Float8.Iota(first), Float8.Of(2f), Float8.Of(bottom)), dy = y - Float8.Of(cy), middle = Float8.Fma(Float8.Of(slant), dy + Float8.Of(0.5f), Float8.Of(cx));
            Float8 start = -Float8.Floor(-Float8.Max(middle - Float8.Of(reach), Float8.Of(left))), width = Float8.Min(middle + Float8.Of(reach), Float8.Of(right)) - start;
            Int8.Store(Float8.ToInt32(Float8.Floor(width * Float8.Of(0.25f)) + Float8.Of(1f)), counts);
            ((Float8*)starts)[0] = start;
            ((Float8*)starts)[1] = y;
            ((Float8*)starts)[2] = Float8.Fma(Float8.Of(sy), dy, Float8.Of(-sx * cx));
            ((Float8*)starts)[3] = Float8.Fma(Float8.Of(ty), dy, Float8.Of(-tx * cx));
            int end = Math.Min(pairs - first, Float8.Width);
            for (int i = 0; i < end; i++)
            {
                float x = starts[i], rowS = starts[i + (2 * Float8.Width)], rowT = starts[i + (3 * Float8.Width)];
                blocks.Row(float.ConvertToIntegerNative<int>(starts[i + Float8.Width]));
                for (int count = counts[i]; count > 0; count--)
                {
                    blocks.Read(float.ConvertToIntegerNative<int>(x), out Float8 lower0, out Float8 lower2, out Float8 upper0, out Float8 upper2);
                    Float8 s = blockS + Float8.Of(MathF.FusedMultiplyAdd(sx, x, rowS)), t = blockT + Float8.Of(MathF.FusedMultiplyAdd(tx, x, rowT));
                    Float8 shareS = Float8.Max(Float8.Min(endS - Float8.Abs(s), one), Float8.Zero), shareT = Float8.Max(Float8.Min(endT - Float8.Abs(t), one), Float8.Zero);
                    Float8 weight = TWeights.Joint(shareS, shareT, s ^ t, skew);
                    even = Float8.Fma(Float8.Spread(weight, 0), lower0, even);
                    odd = Float8.Fma(Float8.Spread(weight, 1), lower2, odd);
                    even = Float8.Fma(Float8.Spread(weight, 2), upper0, even);
                    odd = Float8.Fma(Float8.Spread(weight, 3), upper2, odd);
                    x += 4;
                }
            }
        }

        Float8 sums = even + odd;
        Float4 sum = Float8.Lower(sums) + Float8.Upper(sums);
        return sum / Float4.Of(Float4.Get(sum, 3));
    }

    /// <summary>Footprints of one group of lanes, texels of the picture.</summary>
    private readonly struct Sides<F>
        where F : unmanaged, IReal<F>
    {
        private readonly F _w, _h, _ax, _ay, _bx, _by;

        public Sides(in FootprintColumns footprints, in TexelAxis across, in TexelAxis up, int packet)
        {
            _w = F.Of(across.Size);
            _h = F.Of(up.Size);

            // More than the whole picture is the whole picture.
            _ax = Within(((F*)footprints.DuDx)[packet] * _w, _w);
            _ay = Within(((F*)footprints.DvDx)[packet] * _h, _h);
            _bx = Within(((F*)footprints.DuDy)[packet] * _w, _w);
            _by = Within(((F*)footprints.DvDy)[packet] * _h, _h);
            LongerSquare = EwaKernel.LongerSquare(_ax, _ay, _bx, _by);
        }

        /// <summary>Square of the longer axis; anything for footprints that are no numbers.</summary>
        public F LongerSquare { get; }

        /// <summary>The level, [0, last].</summary>
        /// <param name="last">The highest one.</param>
        /// <param name="isTooLong">Mask of lanes whose level is higher than their shorter axis asks for.</param>
        public F Level(int last, out F isTooLong)
        {
            F area = F.Fma(_ax, _by, -(_ay * _bx)), shorter = area * area / LongerSquare, least = LongerSquare * F.Of(1.0 / (MaxAnisotropy * MaxAnisotropy));
            isTooLong = F.Less(shorter, least) & F.Less(F.Of(4), least);
            F size = F.Min(shorter, F.Max(shorter * F.Of(1.0 / 4), LongerSquare * F.Of(1.0 / 256)));
            F level = F.Floor(F.Exponent(F.Max(F.Max(size, least), F.Of(1))) * F.Of(0.5));
            return F.Max(F.Min(level, F.Of(last)), F.Zero);
        }

        /// <summary>Writes the weights of texels of a level.</summary>
        public void Store(F columns, F rows, F centerX, F centerY, F* numbers)
        {
            F x = columns / _w, y = rows / _h;
            EwaKernel.Store(_ax * x, _ay * y, _bx * x, _by * y, centerX, centerY, numbers);
        }

        /// <summary>A step no longer than the picture; what is not a number stays so.</summary>
        private static F Within(F step, F size) => F.Min(size, F.Max(-size, step));
    }
}
