using System.Runtime.CompilerServices;

namespace LabRaytracer;

/// <summary>Alpha of 8-bit texels, code / 255, in all channels.</summary>
internal readonly unsafe struct Alpha8Reader(int* texels) : ITexelReader
{
    public void Prefetch(int texel) => CacheLine.PrefetchFar(texels + texel);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void Read<F, I>(I texel, out F red, out F green, out F blue)
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I> =>
        red = green = blue = Linear8Reader.Share<F, I>(I.ShiftRight(I.Gather(texels, texel), 24));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void ReadPair<F, I>(I* texel, out F red0, out F green0, out F blue0, out F red1, out F green1, out F blue1)
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I>
    {
        I.LoadPairs(texels, texel, out I left, out I right);
        red0 = green0 = blue0 = Linear8Reader.Share<F, I>(I.ShiftRight(left, 24));
        red1 = green1 = blue1 = Linear8Reader.Share<F, I>(I.ShiftRight(right, 24));
    }
}

/// <summary>Alpha of 16-bit texels, code / 65535, in all channels.</summary>
internal readonly unsafe struct Alpha16Reader(int* texels) : ITexelReader
{
    public void Prefetch(int texel) => CacheLine.PrefetchFar(texels + (2L * texel));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void Read<F, I>(I texel, out F red, out F green, out F blue)
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I> =>
        red = green = blue = F.FromInt32(I.ShiftRight(I.Gather(texels + 1, texel + texel), 16)) / F.Of(65535);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void ReadPair<F, I>(I* texel, out F red0, out F green0, out F blue0, out F red1, out F green1, out F blue1)
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I>
    {
        Read(*texel, out red0, out green0, out blue0);
        Read(*texel + I.Of(1), out red1, out green1, out blue1);
    }
}

/// <summary>Alpha of float texels, in all channels.</summary>
internal readonly unsafe struct AlphaFloatReader(float* texels) : ITexelReader
{
    public void Prefetch(int texel) => CacheLine.PrefetchFar(texels + (4L * texel));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void Read<F, I>(I texel, out F red, out F green, out F blue)
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I> =>
        red = green = blue = F.Gather((F*)(texels + 3), texel * I.Of(4));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void ReadPair<F, I>(I* texel, out F red0, out F green0, out F blue0, out F red1, out F green1, out F blue1)
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I>
    {
        Read(*texel, out red0, out green0, out blue0);
        Read(*texel + I.Of(1), out red1, out green1, out blue1);
    }
}

/// <summary>Colour times alpha.</summary>
/// <typeparam name="TColor">Reads linear colours.</typeparam>
/// <typeparam name="TAlpha">Reads alpha.</typeparam>
internal readonly unsafe struct PremultipliedReader<TColor, TAlpha>(TColor color, TAlpha alpha) : ITexelReader
    where TColor : struct, ITexelReader
    where TAlpha : struct, ITexelReader
{
    public void Prefetch(int texel) => color.Prefetch(texel);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void Read<F, I>(I texel, out F red, out F green, out F blue)
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I>
    {
        color.Read<F, I>(texel, out red, out green, out blue);
        alpha.Read<F, I>(texel, out F share, out _, out _);
        red *= share;
        green *= share;
        blue *= share;
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void ReadPair<F, I>(I* texel, out F red0, out F green0, out F blue0, out F red1, out F green1, out F blue1)
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I>
    {
        color.ReadPair(texel, out red0, out green0, out blue0, out red1, out green1, out blue1);
        alpha.ReadPair<F, I>(texel, out F left, out _, out _, out F right, out _, out _);
        red0 *= left;
        green0 *= left;
        blue0 *= left;
        red1 *= right;
        green1 *= right;
        blue1 *= right;
    }
}
