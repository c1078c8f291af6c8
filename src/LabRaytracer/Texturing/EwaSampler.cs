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
            uint large = F.Bits(F.Less(F.Of(1), sizes[packet]));
            if (large != 0)
            {
                fallbacks += Average<R, F, I>(lookups, across, up, large, colors, packet);
            }
        }

        CountFallbacks(fallbacks);
    }

    /// <summary>Averages over the footprints of some lanes.</summary>
    /// <returns>How many were too long.</returns>
    [SkipLocalsInit]
    [MethodImpl(MethodImplOptions.NoInlining)]
    private int Average<R, F, I>(in LookupBatch<R> lookups, in TexelAxis across, in TexelAxis up, uint large, in ColorColumns<F> colors, int packet)
        where R : unmanaged, ILane<R, F, I>
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I>
    {
        Sides<F> sides = new(lookups.Footprints, across, up, packet);
        F level = sides.Level(Pyramid.LevelCount - 1, out F isTooLong);
        I number = F.ToInt32(level);
        F columns = F.FromInt32(I.Gather(Pyramid.Widths, number)), rows = F.FromInt32(I.Gather(Pyramid.Heights, number));
        F* numbers = stackalloc F[EwaKernel.Numbers + 2];
        sides.Store(columns, rows, numbers);
        numbers[EwaKernel.Numbers] = level;
        numbers[EwaKernel.Numbers + 1] = F.Min((sides.LongerSquare - F.Of(1)) * F.Of(1.0 / 3), F.Of(1));
        R u = lookups.Coordinates.U[packet], v = lookups.Coordinates.V[packet];
        R* places = stackalloc R[2];
        places[0] = R.Fma(Place(across, u), R.FromSingle(columns), R.Of(-0.5));
        places[1] = R.Fma(Place(up, v), R.FromSingle(rows), R.Of(-0.5));
        large &= ~R.Bits(across.Outside(u) | up.Outside(v));
        int first = packet * F.Width, width = F.Width;
        for (uint open = large; open != 0; open &= open - 1)
        {
            int lane = System.Numerics.BitOperations.TrailingZeroCount(open), next = System.Numerics.BitOperations.TrailingZeroCount(open & (open - 1));
            float* n = (float*)numbers + lane;
            if (next < width)
            {
                Prefetch((int)n[(EwaKernel.Numbers * width) + next - lane], new EwaKernel(n + next - lane, width, R.Take(places, next), R.Take(places + 1, next)));
            }

            Float4 mean = Mean((int)n[EwaKernel.Numbers * width], across.Wrap, up.Wrap, new EwaKernel(n, width, R.Take(places, lane), R.Take(places + 1, lane)));
            float share = n[(EwaKernel.Numbers + 1) * width];
            Intensity color = new((float)Float4.Get(mean, 0), (float)Float4.Get(mean, 1), (float)Float4.Get(mean, 2));
            colors.Put(first + lane, share >= 1 ? color : Intensity.Lerp(colors.Take(first + lane), color, share));
        }

        return System.Numerics.BitOperations.PopCount(F.Bits(isTooLong) & large);
    }

    private void Require(int level)
    {
        Pyramid.Require(level, Threads);
        if (level == 0 && Pyramid.HasPicture)
        {
            Pyramid.RequirePicture();
        }
    }

    /// <summary>Asks the memory for the texels of the next lookup, whose rows lie far apart.</summary>
    [MethodImpl(MethodImplOptions.NoInlining)]
    private void Prefetch(int level, in EwaKernel kernel)
    {
        if (level == 0 && !Pyramid.HasPicture)
        {
            return;
        }

        nint stride = MipPyramid.Channels * Pyramid.Strides[level];
        int reach = (int)kernel.ReachY;
        int first = Math.Max(-reach, -kernel.Row), end = Math.Min(reach + 1, Pyramid.Heights[level] - 1 - kernel.Row);
        float* row = Pyramid.Texels + (MipPyramid.Channels * (Pyramid.Starts[level] + (nint)kernel.Column)) + ((kernel.Row + first) * stride);
        float x = kernel.Slant * first * MipPyramid.Channels, step = kernel.Slant * MipPyramid.Channels;
        for (int y = first; y <= end; y++)
        {
            CacheLine.Prefetch(row + float.ConvertToIntegerNative<int>(x));
            row += stride;
            x += step;
        }
    }

    /// <summary>The mean over one footprint.</summary>
    private Float4 Mean(int level, TextureWrap wrapU, TextureWrap wrapV, in EwaKernel kernel)
    {
        Require(level);
        int width = Pyramid.Widths[level], height = Pyramid.Heights[level];
        bool isPacked = level == 0 && !Pyramid.HasPicture;

        // Blocks may begin up to a texel before the reach and end three behind it.
        int reachX = (int)kernel.ReachX + 2, reachY = (int)kernel.ReachY + 2;
        bool isInside = !isPacked && kernel.Column >= reachX && kernel.Column < width - reachX - 4 && kernel.Row >= reachY && kernel.Row < height - reachY - 2;
        if (isInside)
        {
            nint stride = Pyramid.Strides[level];
            nint center = Pyramid.Starts[level] + (kernel.Row * stride) + kernel.Column;
            EwaInnerBlocks inner = new(Pyramid.Texels + (MipPyramid.Channels * center), MipPyramid.Channels * stride);
            return kernel.Skew == 0 ? Sum<EwaInnerBlocks, Straight>(ref inner, kernel) : Sum<EwaInnerBlocks, Skewed>(ref inner, kernel);
        }

        EwaLevel texels = new(Pyramid, level, Start, wrapU, wrapV);
        if (isPacked)
        {
            EwaPackedBlocks<TReader> packed = new(texels, Reader, kernel.Column, kernel.Row);
            return Sum<EwaPackedBlocks<TReader>, Skewed>(ref packed, kernel);
        }

        EwaOuterBlocks outer = new(texels, Pyramid, kernel.Column, kernel.Row);
        return kernel.Skew == 0 ? Sum<EwaOuterBlocks, Straight>(ref outer, kernel) : Sum<EwaOuterBlocks, Skewed>(ref outer, kernel);
    }

    /// <summary>The mean of texels by their weights.</summary>
    [MethodImpl(MethodImplOptions.NoInlining)]
    private static Float4 Sum<TBlocks, TWeights>(ref TBlocks blocks, in EwaKernel kernel)
        where TBlocks : struct, IEwaBlocks
        where TWeights : struct, IEwaWeights
    {
        Float8 one = Float8.Of(1f), columns = Float8.Join(Float4.Iota(0), Float4.Iota(0)), rows = Float8.Join(Float4.Zero, Float4.Of(1));
        Float8 blockS = Float8.Fma(columns, Float8.Of(kernel.SX), rows * Float8.Of(kernel.SY)), blockT = Float8.Fma(columns, Float8.Of(kernel.TX), rows * Float8.Of(kernel.TY));
        Float8 endS = Float8.Of(kernel.SEnd), endT = Float8.Of(kernel.TEnd), even = Float8.Zero, odd = Float8.Zero;
        float sx = kernel.SX, tx = kernel.TX, sy = kernel.SY, ty = kernel.TY, skew = kernel.Skew, slant = kernel.Slant, reach = kernel.Reach;
        float cx = kernel.CenterX, cy = kernel.CenterY, leftS = -sx * cx, leftT = -tx * cx, end = cy + kernel.ReachY;
        float left = cx - kernel.ReachX, right = cx + kernel.ReachX;

        // Rows and columns are whole numbers, a few hundred at most, exact as floats.
        for (float y = MathF.Ceiling(cy - kernel.ReachY); y <= end; y += 2)
        {
            float dy = y - cy, middle = MathF.FusedMultiplyAdd(slant, dy + 0.5f, cx), to = MathF.Min(middle + reach, right);
            float rowS = MathF.FusedMultiplyAdd(sy, dy, leftS), rowT = MathF.FusedMultiplyAdd(ty, dy, leftT);
            blocks.Row(float.ConvertToIntegerNative<int>(y));
            for (float x = MathF.Ceiling(MathF.Max(middle - reach, left)); x <= to; x += 4)
            {
                blocks.Read(float.ConvertToIntegerNative<int>(x), out Float8 lower0, out Float8 lower2, out Float8 upper0, out Float8 upper2);
                Float8 s = blockS + Float8.Of(MathF.FusedMultiplyAdd(sx, x, rowS)), t = blockT + Float8.Of(MathF.FusedMultiplyAdd(tx, x, rowT));
                Float8 shareS = Float8.Max(Float8.Min(endS - Float8.Abs(s), one), Float8.Zero), shareT = Float8.Max(Float8.Min(endT - Float8.Abs(t), one), Float8.Zero);
                Float8 weight = TWeights.Joint(shareS, shareT, s ^ t, skew);
                even = Float8.Fma(Float8.Spread(weight, 0), lower0, even);
                odd = Float8.Fma(Float8.Spread(weight, 1), lower2, odd);
                even = Float8.Fma(Float8.Spread(weight, 2), upper0, even);
                odd = Float8.Fma(Float8.Spread(weight, 3), upper2, odd);
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
        public void Store(F columns, F rows, F* numbers)
        {
            F x = columns / _w, y = rows / _h;
            EwaKernel.Store(_ax * x, _ay * y, _bx * x, _by * y, numbers);
        }

        /// <summary>A step no longer than the picture; what is not a number stays so.</summary>
        private static F Within(F step, F size) => F.Min(size, F.Max(-size, step));
    }
}
