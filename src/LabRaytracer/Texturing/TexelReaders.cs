using System.Runtime.CompilerServices;

namespace LabRaytracer;

/// <summary>8-bit codes decoded by a table of 256 floats.</summary>
internal readonly unsafe struct Table8Reader(int* texels, float* table) : ITexelReader
{
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void Read<F, I>(I texel, out F red, out F green, out F blue)
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I>
    {
        I packed = I.Gather(texels, texel);
        red = F.Gather((F*)table, packed & I.Of(255));
        green = F.Gather((F*)table, I.ShiftRight(packed, 8) & I.Of(255));
        blue = F.Gather((F*)table, I.ShiftRight(packed, 16) & I.Of(255));
    }
}

/// <summary>8-bit codes that mean code / 255: divided exactly instead of looked up.</summary>
internal readonly unsafe struct Linear8Reader(int* texels) : ITexelReader
{
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void Read<F, I>(I texel, out F red, out F green, out F blue)
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I>
    {
        I packed = I.Gather(texels, texel);
        red = Share<F, I>(packed & I.Of(255));
        green = Share<F, I>(I.ShiftRight(packed, 8) & I.Of(255));
        blue = Share<F, I>(I.ShiftRight(packed, 16) & I.Of(255));
    }

    /// <summary>code / 255, correctly rounded: one Newton correction of the product with 1/255 makes all 256 quotients exact (tested).</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static F Share<F, I>(I code)
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I>
    {
        F value = F.FromInt32(code);
        F inverse = F.Of(1.0 / 255);
        F quotient = value * inverse;
        return F.Fma(F.Fma(quotient, F.Of(-255), value), inverse, quotient);
    }
}

/// <summary>16-bit codes decoded by a table of 65536 floats.</summary>
internal readonly unsafe struct Table16Reader(int* texels, float* table) : ITexelReader
{
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
}

/// <summary>Four floats a texel, linear.</summary>
internal readonly unsafe struct FloatReader(float* texels) : ITexelReader
{
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
}
