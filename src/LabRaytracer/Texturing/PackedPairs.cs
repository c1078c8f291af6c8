using System.Runtime.CompilerServices;

namespace LabRaytracer;

/// <summary>The same as <see cref="TexelPairs"/> for packed texels: numbers of elements are bytes, and right neighbours are always behind.</summary>
internal static unsafe class PackedPairs
{
    /// <summary>1 / <see cref="PackedTexels.LineTexels"/> in units of 2^-20, rounded up: the product with up to 65536 columns is exact once it is rounded down.</summary>
    private const int InverseOfLine = ((1 << InverseShift) / PackedTexels.LineTexels) + 1;

    private const int InverseShift = 20;

    /// <summary>Locates the texels of some groups of lanes.</summary>
    /// <param name="texels">The texels.</param>
    /// <param name="across">Horizontal axis, a usual one.</param>
    /// <param name="up">Vertical axis, a usual one.</param>
    /// <param name="u">Horizontal coordinates.</param>
    /// <param name="v">Vertical coordinates.</param>
    /// <param name="block">Receives the texels.</param>
    /// <param name="packets">Groups of lanes, at most those of a block.</param>
    public static void Locate<R, F, I>(PackedTexels texels, in TexelAxis across, in TexelAxis up, R* u, R* v, in BilinearBlock<F, I> block, int packets)
        where R : unmanaged, ILane<R, F, I>
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I>
    {
        // Eight doubles are two registers of which there are few: half as many lanes at a time stay in them.
        if (typeof(R) == typeof(Double8))
        {
            Choose<Double4, Float4, Int4>(
                texels, across, up, (Double4*)u, (Double4*)v, (Int4*)block.Below, (Int4*)block.Above, (Float4*)block.WeightRight, (Float4*)block.WeightAbove, 2 * packets);
        }
        else
        {
            Choose<R, F, I>(texels, across, up, u, v, block.Below, block.Above, block.WeightRight, block.WeightAbove, packets);
        }

        for (int packet = 0; packet < packets; packet++)
        {
            block.Across[packet] = I.Of(1);
            block.Inside[packet] = F.True;
        }
    }

    private static void Choose<R, F, I>(
        PackedTexels texels, in TexelAxis across, in TexelAxis up, R* u, R* v, I* below, I* above, F* right, F* upper, int packets)
        where R : unmanaged, ILane<R, F, I>
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I>
    {
        if (across.Wrap == TextureWrap.Repeat)
        {
            Columns<RepeatedAxis, R, F, I>(texels.Width, u, below, right, packets);
        }
        else
        {
            Columns<ClampedAxis, R, F, I>(texels.Width, u, below, right, packets);
        }

        if (up.Wrap == TextureWrap.Repeat)
        {
            Rows<RepeatedAxis, R, F, I>(texels.Height, texels.BandBytes, v, below, above, upper, packets);
        }
        else
        {
            Rows<ClampedAxis, R, F, I>(texels.Height, texels.BandBytes, v, below, above, upper, packets);
        }
    }

    /// <remarks>Where an end goes on, both texels are the same one: then the neighbour behind gets no weight, which gives the same colour.</remarks>
    [MethodImpl(MethodImplOptions.NoInlining)]
    private static void Columns<TWrap, R, F, I>(int size, R* u, I* left, F* weight, int packets)
        where TWrap : struct, IAxisWrap
        where R : unmanaged, ILane<R, F, I>
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I>
    {
        const int Skipped = PackedTexels.PageBytes - (PackedTexels.LineTexels * PackedTexels.TexelBytes);
        for (int packet = 0; packet < packets; packet++)
        {
            TWrap.Between<R, F, I>(u[packet], size, out I first, out I second, out F share);
            weight[packet] = share & ~F.MaskFromInt32(I.Equal(first, second));
            I line = I.ShiftRight(first * I.Of(InverseOfLine), InverseShift);
            left[packet] = (line * I.Of(Skipped)) + (first * I.Of(PackedTexels.TexelBytes));
        }
    }

    [MethodImpl(MethodImplOptions.NoInlining)]
    private static void Rows<TWrap, R, F, I>(int size, int band, R* v, I* below, I* above, F* weight, int packets)
        where TWrap : struct, IAxisWrap
        where R : unmanaged, ILane<R, F, I>
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I>
    {
        for (int packet = 0; packet < packets; packet++)
        {
            TWrap.Between<R, F, I>(v[packet], size, out I first, out I second, out weight[packet]);
            I left = below[packet], last = I.Of(size - 1);
            below[packet] = left + Row(last - first, band);
            above[packet] = left + Row(last - second, band);
        }
    }

    /// <summary>The first byte of a row.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static I Row<I>(I row, int band)
        where I : unmanaged, IIndexLane<I> =>
        (I.ShiftRight(row, PackedTexels.PageShift) * I.Of(band)) + ((row & I.Of((1 << PackedTexels.PageShift) - 1)) * I.Of(PackedTexels.LineBytes));
}
