using System.Runtime.CompilerServices;

namespace LabRaytracer;

/// <summary>Mixes the bilinear colours of the two levels of a pyramid whose texels are nearest to the longer side of the footprint in size.</summary>
/// <typeparam name="TReader">Reads the store's format.</typeparam>
/// <remarks>
/// With s the longer side of the footprint in texels of the picture, the level is log2(s): at s = 1 the picture itself, bilinear.
/// The logarithm is exact at powers of two and within 0.001 between them.
/// </remarks>
internal sealed unsafe class TrilinearSampler<TReader>(
    TexelStore store, float[]? table, TReader reader, SamplingOptions options, MipPyramid pyramid) : MipSampler<TReader>(store, table, reader, options, pyramid)
    where TReader : struct, ITexelReader
{
    [SkipLocalsInit]
    protected override void Filter<R, F, I>(in LookupBatch<R> lookups, in TexelAxis across, in TexelAxis up, in ColorColumns<F> colors, int packets)
    {
        F* levels = stackalloc F[packets];
        F highest = F.Zero;
        for (int packet = 0; packet < packets; packet++)
        {
            levels[packet] = Level<F>(lookups.Footprints, across.Size, up.Size, packet);
            highest = F.Max(levels[packet], highest);
        }

        Pyramid.Require(Math.Min((int)F.Largest(highest) + 1, Pyramid.LevelCount - 1), Threads);
        Enlarge<R, F, I>(lookups, colors, levels, 1, packets);
        for (int packet = 0; packet < packets; packet++)
        {
            if (F.Any(F.Less(F.Zero, levels[packet])))
            {
                Mix<R, F, I>(lookups, across, up, levels[packet], colors, packet);
            }
        }
    }

    /// <summary>The level of each lane, [0, last].</summary>
    [MethodImpl(MethodImplOptions.NoInlining)]
    private F Level<F>(in FootprintColumns footprints, int width, int height, int packet)
        where F : unmanaged, IReal<F>
    {
        F w = F.Of(width), h = F.Of(height);
        F ux = ((F*)footprints.DuDx)[packet] * w, vx = ((F*)footprints.DvDx)[packet] * h;
        F uy = ((F*)footprints.DuDy)[packet] * w, vy = ((F*)footprints.DvDy)[packet] * h;
        F square = F.Max(F.Fma(ux, ux, vx * vx), F.Fma(uy, uy, vy * vy));

        // What is not a number counts as a point.
        square = F.Min(F.Max(square, F.Of(1)), F.Of(1e18));
        F exponent = F.Exponent(square);
        F m = square * F.PowerOfTwo(-exponent);
        F log = F.Fma(F.Fma(F.Fma(F.Of(0.155446), m, F.Of(-1.044262)), m, F.Of(3.044664)), m, F.Of(-2.155848));
        return F.Min(F.Max((exponent + log) * F.Of(0.5), F.Zero), F.Of(Pyramid.LevelCount - 1));
    }

    private void Mix<R, F, I>(in LookupBatch<R> lookups, in TexelAxis across, in TexelAxis up, F level, in ColorColumns<F> colors, int packet)
        where R : unmanaged, ILane<R, F, I>
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I>
    {
        R u = lookups.Coordinates.U[packet], v = lookups.Coordinates.V[packet];
        F x = R.ToSingle(Place(across, u)), y = R.ToSingle(Place(up, v));
        F floor = F.Floor(level), above = level - floor;
        I lower = F.ToInt32(floor), one = I.Of(1), last = I.Of(Pyramid.LevelCount - 1);
        F red = colors.R[packet], green = colors.G[packet], blue = colors.B[packet];
        F isPicture = F.Less(level, F.Of(1));
        if (!F.All(isPicture))
        {
            Bilinear(I.Max(lower, one), across.Wrap, up.Wrap, x, y, out F r, out F g, out F b);
            red = F.Select(isPicture, red, r);
            green = F.Select(isPicture, green, g);
            blue = F.Select(isPicture, blue, b);
        }

        Bilinear(I.Min(lower + one, last), across.Wrap, up.Wrap, x, y, out F r1, out F g1, out F b1);
        F inside = ~R.MaskToSingle(across.Outside(u) | up.Outside(v));
        colors.R[packet] = F.Fma(above, r1 - red, red) & inside;
        colors.G[packet] = F.Fma(above, g1 - green, green) & inside;
        colors.B[packet] = F.Fma(above, b1 - blue, blue) & inside;
    }

    /// <summary>Bilinear colours of levels from 1 on, a level a lane.</summary>
    [MethodImpl(MethodImplOptions.NoInlining)]
    private void Bilinear<F, I>(I level, TextureWrap wrapU, TextureWrap wrapV, F x, F y, out F red, out F green, out F blue)
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I>
    {
        I width = I.Gather(Pyramid.Widths, level), height = I.Gather(Pyramid.Heights, level), start = I.Gather(Pyramid.Starts, level), stride = I.Gather(Pyramid.Strides, level);
        F px = F.Fma(x, F.FromInt32(width), F.Of(-0.5)), py = F.Fma(y, F.FromInt32(height), F.Of(-0.5));
        F fx = F.Floor(px), fy = F.Floor(py);
        F right = px - fx, above = py - fy;
        I x0 = F.ToInt32(fx), y0 = F.ToInt32(fy), one = I.Of(1);
        (I left, I next) = Pair(x0, width, wrapU);
        (I below, I top) = Pair(y0, height, wrapV);
        I row0 = start + (below * stride), row1 = start + (top * stride);
        I a = row0 + left, b = row0 + next, c = row1 + left, d = row1 + next;
        if (wrapV == TextureWrap.Pole)
        {
            // Beyond a pole lies the row nearest to it, half a turn away.
            I far0 = I.Less(y0, I.Of(0)), far1 = I.Less(height, y0 + one + one);
            (I farLeft, I farNext) = (Turned(left, width), Turned(next, width));
            a = I.Select(far0, row0 + farLeft, a);
            b = I.Select(far0, row0 + farNext, b);
            c = I.Select(far1, row1 + farLeft, c);
            d = I.Select(far1, row1 + farNext, d);
        }

        I channels = I.Of(MipPyramid.Channels);
        (a, b, c, d) = (a * channels, b * channels, c * channels, d * channels);
        Between<F, I>(Pyramid.Texels, a, b, c, d, right, above, out red, out green, out blue);
    }

    /// <summary>The texel at a place, [-1, size), and the next one, inside the picture.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static (I First, I Second) Pair<I>(I texel, I size, TextureWrap wrap)
        where I : unmanaged, IIndexLane<I>
    {
        I zero = I.Of(0), last = size - I.Of(1);
        I first = I.Min(texel, last), second = texel + I.Of(1);
        return wrap == TextureWrap.Repeat
            ? (I.Max(I.Select(I.Less(first, zero), last, first), zero), I.Max(I.Select(I.Less(last, second), zero, second), zero))
            : (I.Max(first, zero), I.Max(I.Min(second, last), zero));
    }

    /// <summary>The column half a turn away.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static I Turned<I>(I x, I width)
        where I : unmanaged, IIndexLane<I>
    {
        I turned = x + I.ShiftRight(width, 1);
        return I.Select(I.Less(turned, width), turned, turned - width);
    }

    /// <summary>Colours between four texels, lane by lane: the components of a texel lie side by side, and four texels are read and turned sooner than twelve columns are gathered.</summary>
    [SkipLocalsInit]
    private static void Between<F, I>(float* texels, I a, I b, I c, I d, F right, F above, out F red, out F green, out F blue)
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I>
    {
        int* places = stackalloc int[4 * F.Width];
        I.Store(a, places);
        I.Store(b, places + F.Width);
        I.Store(c, places + (2 * F.Width));
        I.Store(d, places + (3 * F.Width));
        F* both = stackalloc F[2];
        (both[0], both[1]) = (right, above);
        float* shares = (float*)both;
        Float4* colors = stackalloc Float4[Math.Max(F.Width, 4)];
        for (int lane = 0; lane < F.Width; lane++)
        {
            colors[lane] = Between(texels, places + lane, shares + lane, F.Width);
        }

        LaneTriples.Turn(colors, out red, out green, out blue);
    }

    /// <summary>The colour of one lane: four places and two shares, a group of lanes apart.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Float4 Between(float* texels, int* places, float* shares, int width)
    {
        Float4 a = Float4.Load(texels + places[0]), b = Float4.Load(texels + places[width]), c = Float4.Load(texels + places[2 * width]), d = Float4.Load(texels + places[3 * width]);
        Float4 right = Float4.Of(shares[0]), low = Float4.Fma(right, b - a, a), high = Float4.Fma(right, d - c, c);
        return Float4.Fma(Float4.Of(shares[width]), high - low, low);
    }
}
