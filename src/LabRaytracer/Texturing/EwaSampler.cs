using System.Runtime.CompilerServices;

namespace LabRaytracer;

/// <summary>Elliptical weighted average: a weighted mean of the texels inside the ellipse of the footprint (Greene and Heckbert 1986).</summary>
/// <typeparam name="TReader">Reads the store's format.</typeparam>
/// <remarks>
/// <para>The level is the smallest of the pyramid whose texels are not larger than the shorter side of the footprint, which counts as at least 1/64 of the longer one.
/// So an ellipse is at most 2 texels wide at the shorter side and 128 at the longer one, plus the reach of its weights: at most 160 rows of 160 texels.</para>
/// <para>Footprints not longer than a texel are bilinear; up to twice as long, a mix of both.</para>
/// <para>The sums run over texels of a row, eight at a time, the same on every machine.</para>
/// </remarks>
internal sealed unsafe class EwaSampler<TReader>(
    TexelStore store, float[]? table, TReader reader, SamplingOptions options, MipPyramid pyramid) : MipSampler<TReader>(store, table, reader, options, pyramid)
    where TReader : struct, ITexelReader
{
    /// <summary>The most that the longer side of a footprint may be of the shorter one.</summary>
    public const int MaxAnisotropy = 64;

    [SkipLocalsInit]
    protected override void Filter<R, F, I>(in LookupBatch<R> lookups, in TexelAxis across, in TexelAxis up, in ColorColumns<F> colors, int packets)
    {
        F* sizes = stackalloc F[packets];
        for (int packet = 0; packet < packets; packet++)
        {
            Shape<F> shape = new(lookups.Footprints, across, up, packet);
            sizes[packet] = shape.Longer;
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

    /// <summary>Averages over the ellipses of some lanes.</summary>
    /// <returns>How many were too long.</returns>
    [SkipLocalsInit]
    [MethodImpl(MethodImplOptions.NoInlining)]
    private int Average<R, F, I>(in LookupBatch<R> lookups, in TexelAxis across, in TexelAxis up, uint large, in ColorColumns<F> colors, int packet)
        where R : unmanaged, ILane<R, F, I>
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I>
    {
        Shape<F> shape = new(lookups.Footprints, across, up, packet);
        R u = lookups.Coordinates.U[packet], v = lookups.Coordinates.V[packet];
        R* places = stackalloc R[2];
        places[0] = Place(across, u);
        places[1] = Place(up, v);
        large &= ~R.Bits(across.Outside(u) | up.Outside(v));
        F* numbers = stackalloc F[6];
        shape.Store(numbers, Pyramid.LevelCount - 1);
        float* n = (float*)numbers;
        int first = packet * F.Width, width = F.Width;
        for (uint open = large; open != 0; open &= open - 1)
        {
            int lane = System.Numerics.BitOperations.TrailingZeroCount(open);
            int level = (int)n[(3 * width) + lane];
            Require(level);
            Intensity mean = Mean(level, across.Wrap, up.Wrap, n + lane, width, R.Take(places, lane), R.Take(places + 1, lane));
            float share = n[(4 * width) + lane];
            colors.Put(first + lane, share >= 1 ? mean : Intensity.Lerp(colors.Take(first + lane), mean, share));
        }

        return System.Numerics.BitOperations.PopCount(F.Bits(shape.IsTooLong) & large);
    }

    private void Require(int level)
    {
        Pyramid.Require(level, Threads);
        if (level == 0 && Pyramid.HasPicture)
        {
            Pyramid.RequirePicture();
        }
    }

    /// <summary>The mean over one ellipse.</summary>
    /// <param name="level">The level, which is there.</param>
    /// <param name="wrapU">Wrap of columns.</param>
    /// <param name="wrapV">Wrap of rows.</param>
    /// <param name="shape">The numbers of the footprint.</param>
    /// <param name="stride">Distance of these numbers.</param>
    /// <param name="u">Centre, [0, 1].</param>
    /// <param name="v">Centre, [0, 1].</param>
    private Intensity Mean(int level, TextureWrap wrapU, TextureWrap wrapV, float* shape, int stride, double u, double v)
    {
        EwaLevel texels = new(Pyramid, level, Start, wrapU, wrapV);
        float scaleX = texels.Width / (float)Pyramid.Widths[0], scaleY = texels.Height / (float)Pyramid.Heights[0];
        Ellipse ellipse = new(shape[0] * (scaleX * scaleX), shape[stride] * (scaleX * scaleY), shape[2 * stride] * (scaleY * scaleY), shape[5 * stride]);
        double x = (u * texels.Width) - 0.5, y = (v * texels.Height) - 0.5;
        return level == 0 && !Pyramid.HasPicture ? PictureMean(texels, ellipse, x, y) : LevelMean(texels, ellipse, x, y);
    }

    /// <summary>The mean of texels of a level that is unpacked.</summary>
    [SkipLocalsInit]
    [MethodImpl(MethodImplOptions.NoInlining)]
    private Intensity LevelMean(in EwaLevel texels, in Ellipse ellipse, double centerX, double centerY)
    {
        Float8* apart = stackalloc Float8[3];
        float* planeR = Pyramid.Red, planeG = Pyramid.Green, planeB = Pyramid.Blue;
        Float8 red = Float8.Zero, green = Float8.Zero, blue = Float8.Zero, sum = Float8.Zero, fall = Float8.Of(-ellipse.Fall), iota = Float8.Iota(0);
        int column = double.ConvertToIntegerNative<int>(Math.Floor(centerX)), row = double.ConvertToIntegerNative<int>(Math.Floor(centerY)), limit = texels.Width - Float8.Width;
        float cx = (float)(centerX - column), cy = (float)(centerY - row);
        int end = float.ConvertToIntegerNative<int>(MathF.Floor(cy + ellipse.Height));
        for (int y = float.ConvertToIntegerNative<int>(MathF.Ceiling(cy - ellipse.Height)); y <= end; y++)
        {
            float middle = ellipse.Row(y - cy, cx, out float center, out int from, out int to);
            int start = texels.Row(row + y, out int turn);
            turn += column;
            for (int x = from; x <= to; x += Float8.Width)
            {
                Float8 d = iota + Float8.Of(x - center);
                Float8 weight = Float8.Max(Float8.Fma(d * fall, d, Float8.Of(middle)), Float8.Zero);
                int first = texels.Column(turn + x);
                if (first <= limit)
                {
                    first += start;
                    red = Float8.Fma(weight, *(Float8*)(planeR + first), red);
                    green = Float8.Fma(weight, *(Float8*)(planeG + first), green);
                    blue = Float8.Fma(weight, *(Float8*)(planeB + first), blue);
                }
                else
                {
                    texels.ReadApart(start, turn + x, apart);
                    red = Float8.Fma(weight, apart[0], red);
                    green = Float8.Fma(weight, apart[1], green);
                    blue = Float8.Fma(weight, apart[2], blue);
                }

                sum += weight;
            }
        }

        return Mean(red, green, blue, sum);
    }

    /// <summary>The mean of texels of a large picture, which stays packed.</summary>
    [MethodImpl(MethodImplOptions.NoInlining)]
    private Intensity PictureMean(in EwaLevel texels, in Ellipse ellipse, double centerX, double centerY)
    {
        Float8 red = Float8.Zero, green = Float8.Zero, blue = Float8.Zero, sum = Float8.Zero, fall = Float8.Of(-ellipse.Fall), iota = Float8.Iota(0);
        int column = double.ConvertToIntegerNative<int>(Math.Floor(centerX)), row = double.ConvertToIntegerNative<int>(Math.Floor(centerY)), limit = texels.Width - Float8.Width;
        float cx = (float)(centerX - column), cy = (float)(centerY - row);
        int end = float.ConvertToIntegerNative<int>(MathF.Floor(cy + ellipse.Height));
        for (int y = float.ConvertToIntegerNative<int>(MathF.Ceiling(cy - ellipse.Height)); y <= end; y++)
        {
            float middle = ellipse.Row(y - cy, cx, out float center, out int from, out int to);
            int start = texels.Row(row + y, out int turn);
            turn += column;
            for (int x = from; x <= to; x += Float8.Width)
            {
                Float8 d = iota + Float8.Of(x - center);
                Float8 weight = Float8.Max(Float8.Fma(d * fall, d, Float8.Of(middle)), Float8.Zero);
                int first = texels.Column(turn + x);
                Int8 elements = first <= limit ? Int8.Iota(start + first) : texels.Apart(start, turn + x);
                Reader.Read(elements, out Float8 r, out Float8 g, out Float8 b);
                red = Float8.Fma(weight, r, red);
                green = Float8.Fma(weight, g, green);
                blue = Float8.Fma(weight, b, blue);
                sum += weight;
            }
        }

        return Mean(red, green, blue, sum);
    }

    /// <summary>The mean from eight sums of each; added up in the same order on every machine.</summary>
    [SkipLocalsInit]
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Intensity Mean(Float8 red, Float8 green, Float8 blue, Float8 weight)
    {
        Float4* halves = stackalloc Float4[4];
        halves[0] = Float8.Lower(red) + Float8.Upper(red);
        halves[1] = Float8.Lower(green) + Float8.Upper(green);
        halves[2] = Float8.Lower(blue) + Float8.Upper(blue);
        halves[3] = Float8.Lower(weight) + Float8.Upper(weight);
        float* n = (float*)halves;
        float toMean = 1 / Sum(n + 12);
        return new Intensity(Sum(n) * toMean, Sum(n + 4) * toMean, Sum(n + 8) * toMean);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static float Sum(float* four) => (four[0] + four[2]) + (four[1] + four[3]);

    /// <summary>Footprints of one group of lanes, texels of the picture.</summary>
    private readonly struct Shape<F>
        where F : unmanaged, IReal<F>
    {
        private readonly F _xx, _xy, _yy, _shorter, _least;

        public Shape(in FootprintColumns footprints, in TexelAxis across, in TexelAxis up, int packet)
        {
            F w = F.Of(across.Size), h = F.Of(up.Size);

            // More than the whole picture is the whole picture.
            F ax = Within(((F*)footprints.DuDx)[packet] * w, w), ay = Within(((F*)footprints.DvDx)[packet] * h, h);
            F bx = Within(((F*)footprints.DuDy)[packet] * w, w), by = Within(((F*)footprints.DvDy)[packet] * h, h);
            _xx = F.Fma(ax, ax, bx * bx);
            _xy = F.Fma(ax, ay, bx * by);
            _yy = F.Fma(ay, ay, by * by);
            F area = F.Fma(ax, by, -(ay * bx)), half = (_xx - _yy) * F.Of(0.5);
            Longer = F.Fma(_xx + _yy, F.Of(0.5), F.Sqrt(F.Fma(half, half, _xy * _xy)));
            F shorter = area * area / Longer, least = Longer * F.Of(1.0 / (MaxAnisotropy * MaxAnisotropy));
            IsTooLong = F.Less(shorter, least) & F.Less(F.Of(4), least);
            _shorter = shorter;
            _least = F.Max(F.Max(shorter, least), F.Of(1));
        }

        /// <summary>Square of the longer side; anything for footprints that are no numbers.</summary>
        public F Longer { get; }

        /// <summary>Mask of lanes whose level is higher than their shorter side asks for.</summary>
        public F IsTooLong { get; }

        /// <summary>Writes xx, xy, yy, the level, how much of the result is the average, and the square of the shorter side in texels of the level.</summary>
        public void Store(F* numbers, int last)
        {
            numbers[0] = _xx;
            numbers[1] = _xy;
            numbers[2] = _yy;
            F level = F.Min(F.Floor(F.Exponent(_least) * F.Of(0.5)), F.Of(last));
            numbers[3] = level;
            numbers[4] = F.Min((Longer - F.Of(1)) * F.Of(1.0 / 3), F.Of(1));
            numbers[5] = _shorter * F.PowerOfTwo(F.Of(-2) * level);
        }

        /// <summary>A step no longer than the picture; what is not a number stays so.</summary>
        private static F Within(F step, F size) => F.Min(size, F.Max(-size, step));
    }
}
