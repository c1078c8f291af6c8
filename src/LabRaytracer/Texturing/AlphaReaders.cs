using System.Runtime.CompilerServices;

namespace LabRaytracer;

/// <summary>Alpha of 8-bit texels, code / 255, in all channels.</summary>
internal readonly unsafe struct Alpha8Reader(int* texels) : ITexelReader
{
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void Read<F, I>(I texel, out F red, out F green, out F blue)
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I> =>
        red = green = blue = Linear8Reader.Share<F, I>(I.ShiftRight(I.Gather(texels, texel), 24));
}

/// <summary>Alpha of 16-bit texels, code / 65535, in all channels.</summary>
internal readonly unsafe struct Alpha16Reader(int* texels) : ITexelReader
{
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void Read<F, I>(I texel, out F red, out F green, out F blue)
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I> =>
        red = green = blue = F.FromInt32(I.ShiftRight(I.Gather(texels + 1, texel + texel), 16)) / F.Of(65535);
}

/// <summary>Alpha of float texels, in all channels.</summary>
internal readonly unsafe struct AlphaFloatReader(float* texels) : ITexelReader
{
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void Read<F, I>(I texel, out F red, out F green, out F blue)
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I> =>
        red = green = blue = F.Gather((F*)(texels + 3), texel * I.Of(4));
}

/// <summary>Colour times alpha.</summary>
/// <typeparam name="TColor">Reads linear colours.</typeparam>
/// <typeparam name="TAlpha">Reads alpha.</typeparam>
internal readonly struct PremultipliedReader<TColor, TAlpha>(TColor color, TAlpha alpha) : ITexelReader
    where TColor : struct, ITexelReader
    where TAlpha : struct, ITexelReader
{
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
}
