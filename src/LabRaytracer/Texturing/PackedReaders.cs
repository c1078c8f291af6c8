using System.Runtime.CompilerServices;

namespace LabRaytracer;

/// <summary>Packed 8-bit codes (<see cref="PackedTexels"/>) decoded by a table of 256 floats. Elements are bytes.</summary>
internal readonly unsafe struct PackedTableReader(byte* texels, float* table) : ITexelReader
{
    public void Prefetch(int texel) => CacheLine.PrefetchFar(texels + texel);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void Read<F, I>(I texel, out F red, out F green, out F blue)
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I>
    {
        I.LoadTriples(texels, &texel, out I left, out _);
        Table8Reader.Decode(left, table, out red, out green, out blue);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void ReadPair<F, I>(I* texel, out F red0, out F green0, out F blue0, out F red1, out F green1, out F blue1)
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I>
    {
        I.LoadTriples(texels, texel, out I left, out I right);
        Table8Reader.Decode(left, table, out red0, out green0, out blue0);
        Table8Reader.Decode(right, table, out red1, out green1, out blue1);
    }
}

/// <summary>Packed 8-bit codes that mean code / 255. Elements are bytes.</summary>
internal readonly unsafe struct PackedLinearReader(byte* texels) : ITexelReader
{
    public void Prefetch(int texel) => CacheLine.PrefetchFar(texels + texel);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void Read<F, I>(I texel, out F red, out F green, out F blue)
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I>
    {
        I.LoadTriples(texels, &texel, out I left, out _);
        Linear8Reader.Split(left, out red, out green, out blue);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void ReadPair<F, I>(I* texel, out F red0, out F green0, out F blue0, out F red1, out F green1, out F blue1)
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I>
    {
        I.LoadTriples(texels, texel, out I left, out I right);
        Linear8Reader.Split(left, out red0, out green0, out blue0);
        Linear8Reader.Split(right, out red1, out green1, out blue1);
    }
}
