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

    /// <summary>Mixes the two levels of a group of lanes.</summary>
    [SkipLocalsInit]
    [MethodImpl(MethodImplOptions.NoInlining)]
    private void Mix<R, F, I>(in LookupBatch<R> lookups, in TexelAxis across, in TexelAxis up, in F level, in ColorColumns<F> colors, int packet)
        where R : unmanaged, ILane<R, F, I>
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I>
    {
        F* numbers = stackalloc F[(2 * MipPairs.Numbers) + 1];
        Float4* means = stackalloc Float4[Math.Max(F.Width, 4)];
        R u = lookups.Coordinates.U[packet], v = lookups.Coordinates.V[packet];
        F x = R.ToSingle(Place(across, u)), y = R.ToSingle(Place(up, v)), floor = F.Floor(level), above = level - floor, isPicture = F.Less(level, F.Of(1)), red, green, blue;
        I lower = F.ToInt32(floor), one = I.Of(1);
        MipPairs.Locate(Pyramid, I.Min(lower + one, I.Of(Pyramid.LevelCount - 1)), across.Wrap, up.Wrap, x, y, numbers);
        if (!F.Any(isPicture))
        {
            numbers[2 * MipPairs.Numbers] = above;
            MipPairs.Locate(Pyramid, lower, across.Wrap, up.Wrap, x, y, numbers + MipPairs.Numbers);
            Both<F>(Pyramid.Texels, (float*)numbers, means);
            LaneTriples.Turn(means, out red, out green, out blue);
        }
        else
        {
            // The picture itself is not in the pyramid: its colours are there already.
            One<F>(Pyramid.Texels, (float*)numbers, means);
            LaneTriples.Turn(means, out F red1, out F green1, out F blue1);
            (red, green, blue) = (colors.R[packet], colors.G[packet], colors.B[packet]);
            if (!F.All(isPicture))
            {
                MipPairs.Locate(Pyramid, I.Max(lower, one), across.Wrap, up.Wrap, x, y, numbers);
                One<F>(Pyramid.Texels, (float*)numbers, means);
                LaneTriples.Turn(means, out F red0, out F green0, out F blue0);
                (red, green, blue) = (F.Select(isPicture, red, red0), F.Select(isPicture, green, green0), F.Select(isPicture, blue, blue0));
            }

            (red, green, blue) = (F.Fma(above, red1 - red, red), F.Fma(above, green1 - green, green), F.Fma(above, blue1 - blue, blue));
        }

        F inside = ~R.MaskToSingle(across.Outside(u) | up.Outside(v));
        colors.R[packet] = red & inside;
        colors.G[packet] = green & inside;
        colors.B[packet] = blue & inside;
    }

    /// <summary>Bilinear colours of a level a lane.</summary>
    private static void One<F>(float* texels, float* numbers, Float4* means)
        where F : unmanaged, IReal<F>
    {
        for (int lane = 0; lane < F.Width; lane++)
        {
            means[lane] = MipPairs.Mix(texels, numbers + lane, F.Width);
        }
    }

    /// <summary>Colours between two levels, the upper one first.</summary>
    [MethodImpl(MethodImplOptions.NoInlining)]
    private static void Both<F>(float* texels, float* numbers, Float4* means)
        where F : unmanaged, IReal<F>
    {
        for (int lane = 0; lane < F.Width; lane++)
        {
            Float4 upper = MipPairs.Mix(texels, numbers, F.Width), lower = MipPairs.Mix(texels, numbers + (MipPairs.Numbers * F.Width), F.Width);
            means[lane] = Float4.Fma(Float4.Of(numbers[2 * MipPairs.Numbers * F.Width]), upper - lower, lower);
            numbers++;
        }
    }
}
