using System.Runtime.CompilerServices;

namespace LabRaytracer;

/// <summary>The texels between which coordinates lie, for the usual axes: <see cref="TexelAxis.Between"/> with texels in the middle and no border, compiled into a loop.</summary>
internal static unsafe class TexelPairs
{
    /// <summary>Tells whether an axis is a usual one.</summary>
    public static bool Fits(in TexelAxis axis) =>
        axis.Texels == TexelConvention.Center && axis.Wrap is TextureWrap.Repeat or TextureWrap.Clamp or TextureWrap.Pole && axis.Size >= 1;

    /// <summary>Locates the texels of some groups of lanes.</summary>
    /// <param name="across">Horizontal axis.</param>
    /// <param name="up">Vertical axis.</param>
    /// <param name="start">Element number of the texel (0, 0); rows go down from it.</param>
    /// <param name="u">Horizontal coordinates.</param>
    /// <param name="v">Vertical coordinates.</param>
    /// <param name="block">Receives the texels.</param>
    /// <param name="packets">Groups of lanes, at most those of a block.</param>
    public static void Locate<R, F, I>(in TexelAxis across, in TexelAxis up, int start, R* u, R* v, in BilinearBlock<F, I> block, int packets)
        where R : unmanaged, ILane<R, F, I>
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I>
    {
        // Eight doubles are two registers of which there are few: half as many lanes at a time stay in them.
        if (typeof(R) == typeof(Double8))
        {
            Choose<Double4, Float4, Int4>(
                across, up, start, (Double4*)u, (Double4*)v, (Int4*)block.Below, (Int4*)block.Above, (Int4*)block.Across,
                (Float4*)block.WeightRight, (Float4*)block.WeightAbove, 2 * packets);
        }
        else
        {
            Choose<R, F, I>(across, up, start, u, v, block.Below, block.Above, block.Across, block.WeightRight, block.WeightAbove, packets);
        }

        for (int packet = 0; packet < packets; packet++)
        {
            block.Inside[packet] = F.True;
        }
    }

    private static void Choose<R, F, I>(
        in TexelAxis across, in TexelAxis up, int start, R* u, R* v, I* below, I* above, I* step, F* right, F* upper, int packets)
        where R : unmanaged, ILane<R, F, I>
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I>
    {
        if (across.Wrap == TextureWrap.Repeat)
        {
            Columns<RepeatedAxis, R, F, I>(across.Size, u, below, step, right, packets);
        }
        else
        {
            Columns<ClampedAxis, R, F, I>(across.Size, u, below, step, right, packets);
        }

        if (up.Wrap == TextureWrap.Repeat)
        {
            Rows<RepeatedAxis, R, F, I>(up.Size, across.Size, start, v, below, above, upper, packets);
        }
        else
        {
            Rows<ClampedAxis, R, F, I>(up.Size, across.Size, start, v, below, above, upper, packets);
        }
    }

    [MethodImpl(MethodImplOptions.NoInlining)]
    private static void Columns<TWrap, R, F, I>(int size, R* u, I* left, I* step, F* weight, int packets)
        where TWrap : struct, IAxisWrap
        where R : unmanaged, ILane<R, F, I>
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I>
    {
        for (int packet = 0; packet < packets; packet++)
        {
            TWrap.Between<R, F, I>(u[packet], size, out I first, out I second, out weight[packet]);
            left[packet] = first;
            step[packet] = second - first;
        }
    }

    [MethodImpl(MethodImplOptions.NoInlining)]
    private static void Rows<TWrap, R, F, I>(int size, int width, int start, R* v, I* below, I* above, F* weight, int packets)
        where TWrap : struct, IAxisWrap
        where R : unmanaged, ILane<R, F, I>
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I>
    {
        I origin = I.Of(start), stride = I.Of(width);
        for (int packet = 0; packet < packets; packet++)
        {
            TWrap.Between<R, F, I>(v[packet], size, out I first, out I second, out weight[packet]);
            I left = below[packet];
            below[packet] = origin - (first * stride) + left;
            above[packet] = origin - (second * stride) + left;
        }
    }
}
