using System.Runtime.CompilerServices;

namespace LabRaytracer;

/// <summary>8-bit codes decoded by a table of 256 floats.</summary>
internal readonly unsafe struct Table8Reader(int* texels, float* table) : ITexelReader
{
    public void Prefetch(int texel) => CacheLine.PrefetchFar(texels + texel);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void Read<F, I>(I texel, out F red, out F green, out F blue)
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I> => Decode(I.Gather(texels, texel), table, out red, out green, out blue);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void ReadPair<F, I>(I* texel, out F red0, out F green0, out F blue0, out F red1, out F green1, out F blue1)
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I>
    {
        I.LoadPairs(texels, texel, out I left, out I right);
        Decode(left, table, out red0, out green0, out blue0);
        Decode(right, table, out red1, out green1, out blue1);
    }

    /// <summary>Three codes, the highest byte being of no matter.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void Decode<F, I>(I packed, float* table, out F red, out F green, out F blue)
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I>
    {
        red = F.Gather((F*)table, packed & I.Of(255));
        green = F.Gather((F*)table, I.ShiftRight(packed, 8) & I.Of(255));
        blue = F.Gather((F*)table, I.ShiftRight(packed, 16) & I.Of(255));
    }
}

/// <summary>8-bit codes that mean code / 255: divided exactly instead of looked up.</summary>
internal readonly unsafe struct Linear8Reader(int* texels) : ITexelReader
{
    private const double Inverse = (float)(1.0 / 255);
    private const double InverseRest = (1.0 / 255) - Inverse;

    public void Prefetch(int texel) => CacheLine.PrefetchFar(texels + texel);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void Read<F, I>(I texel, out F red, out F green, out F blue)
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I> => Split(I.Gather(texels, texel), out red, out green, out blue);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void ReadPair<F, I>(I* texel, out F red0, out F green0, out F blue0, out F red1, out F green1, out F blue1)
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I>
    {
        I.LoadPairs(texels, texel, out I left, out I right);
        Split(left, out red0, out green0, out blue0);
        Split(right, out red1, out green1, out blue1);
    }

    /// <summary>Three codes, the highest byte being of no matter.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void Split<F, I>(I packed, out F red, out F green, out F blue)
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I>
    {
        red = Share<F, I>(packed & I.Of(255));
        green = Share<F, I>(I.ShiftRight(packed, 8) & I.Of(255));
        blue = Share<F, I>(I.ShiftRight(packed, 16) & I.Of(255));
    }

    /// <summary>code / 255, correctly rounded for all 256 codes (tested): the product with 1/255 in two parts.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static F Share<F, I>(I code)
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I>
    {
        F value = F.FromInt32(code);
        return F.Fma(value, F.Of(Inverse), value * F.Of(InverseRest));
    }
}

/// <summary>16-bit codes decoded by a table of 65536 floats.</summary>
internal readonly unsafe struct Table16Reader(int* texels, float* table) : ITexelReader
{
    public void Prefetch(int texel) => CacheLine.PrefetchFar(texels + (2L * texel));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void Read<F, I>(I texel, out F red, out F green, out F blue)
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I>
    {
        I pair = texel + texel;
        I redGreen = I.Gather(texels, pair);
        red = F.Gather((F*)table, redGreen & I.Of(65535));
        green = F.Gather((F*)table, I.ShiftRight(redGreen, 16));
        blue = F.Gather((F*)table, I.Gather(texels + 1, pair) & I.Of(65535));
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void ReadPair<F, I>(I* texel, out F red0, out F green0, out F blue0, out F red1, out F green1, out F blue1)
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I>
    {
        Read(*texel, out red0, out green0, out blue0);
        Read(*texel + I.Of(1), out red1, out green1, out blue1);
    }
}

/// <summary>Four floats a texel, linear.</summary>
internal readonly unsafe struct FloatReader(float* texels) : ITexelReader
{
    public void Prefetch(int texel) => CacheLine.PrefetchFar(texels + (4L * texel));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void Read<F, I>(I texel, out F red, out F green, out F blue)
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I>
    {
        I four = texel * I.Of(4);
        red = F.Gather((F*)texels, four);
        green = F.Gather((F*)(texels + 1), four);
        blue = F.Gather((F*)(texels + 2), four);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void ReadPair<F, I>(I* texel, out F red0, out F green0, out F blue0, out F red1, out F green1, out F blue1)
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I>
    {
        Read(*texel, out red0, out green0, out blue0);
        Read(*texel + I.Of(1), out red1, out green1, out blue1);
    }
}
