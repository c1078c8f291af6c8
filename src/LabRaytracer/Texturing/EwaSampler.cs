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
        F* numbers = stackalloc F[5];
        shape.Store(numbers, Pyramid.LevelCount - 1);
        float* n = (float*)numbers;
        int first = packet * F.Width, width = F.Width;
        for (uint open = large; open != 0; open &= open - 1)
        {
            int lane = System.Numerics.BitOperations.TrailingZeroCount(open);
            int level = (int)n[(3 * width) + lane];
            Pyramid.Require(level, Threads);
            EwaSum sum = new(Pyramid, level, across.Wrap, up.Wrap);
            Add(ref sum, n[lane], n[width + lane], n[(2 * width) + lane], R.Take(places, lane), R.Take(places + 1, lane));
            Intensity mean = sum.Mean;
            float share = n[(4 * width) + lane];
            colors.Put(first + lane, share >= 1 ? mean : Intensity.Lerp(colors.Take(first + lane), mean, share));
        }

        return System.Numerics.BitOperations.PopCount(F.Bits(shape.IsTooLong) & large);
    }

    /// <summary>Adds the texels of an ellipse.</summary>
    private void Add(ref EwaSum sum, float xx, float xy, float yy, double u, double v)
    {
        float scaleX = sum.Width / (float)Pyramid.Widths[0], scaleY = sum.Height / (float)Pyramid.Heights[0];
        Ellipse ellipse = new(xx * (scaleX * scaleX), xy * (scaleX * scaleY), yy * (scaleY * scaleY));
        double centerX = (u * sum.Width) - 0.5, centerY = (v * sum.Height) - 0.5;
        int column = (int)Math.Floor(centerX), row = (int)Math.Floor(centerY);
        float cx = (float)(centerX - column), cy = (float)(centerY - row);
        int end = (int)MathF.Floor(cy + ellipse.Height);
        for (int y = (int)MathF.Ceiling(cy - ellipse.Height); y <= end; y++)
        {
            float dy = y - cy, middle = ellipse.Middle(dy);
            if (middle <= 0)
            {
                continue;
            }

            float half = ellipse.HalfWidth(middle), center = MathF.FusedMultiplyAdd(ellipse.Slant, dy, cx);
            int from = (int)MathF.Ceiling(center - half), to = (int)MathF.Floor(center + half);
            sum.StartRow(row + y, Start, store.Width);
            for (int x = from; x <= to; x += Float8.Width)
            {
                Float8 d = Float8.Iota(x - center);
                Float8 weight = Float8.Max(Float8.Fma(d * Float8.Of(-ellipse.Fall), d, Float8.Of(middle)), Float8.Zero);
                if (sum.Level == 0)
                {
                    sum.AddPicture(Reader, column + x, weight);
                }
                else
                {
                    sum.AddLevel(column + x, weight);
                }
            }
        }
    }

    /// <summary>Footprints of one group of lanes, texels of the picture.</summary>
    private readonly struct Shape<F>
        where F : unmanaged, IReal<F>
    {
        private readonly F _xx, _xy, _yy, _shorter;

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
            _shorter = F.Max(F.Max(shorter, least), F.Of(1));
        }

        /// <summary>Square of the longer side; anything for footprints that are no numbers.</summary>
        public F Longer { get; }

        /// <summary>Mask of lanes whose level is higher than their shorter side asks for.</summary>
        public F IsTooLong { get; }

        /// <summary>Writes xx, xy, yy, the level, and how much of the result is the average.</summary>
        public void Store(F* numbers, int last)
        {
            numbers[0] = _xx;
            numbers[1] = _xy;
            numbers[2] = _yy;
            numbers[3] = F.Min(F.Floor(F.Exponent(_shorter) * F.Of(0.5)), F.Of(last));
            numbers[4] = F.Min((Longer - F.Of(1)) * F.Of(1.0 / 3), F.Of(1));
        }

        private static F Within(F step, F size) => F.Min(F.Max(step, -size), size);
    }
}
