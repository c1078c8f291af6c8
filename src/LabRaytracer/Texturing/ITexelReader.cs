namespace LabRaytracer;

/// <summary>Reads packed texels of one format as linear colour.</summary>
internal interface ITexelReader
{
    /// <summary>Asks the memory for a texel that will soon be read.</summary>
    void Prefetch(int texel);

    /// <summary>Linear colours of texels.</summary>
    /// <param name="texel">Element numbers of the texels in the store.</param>
    /// <param name="red">Red.</param>
    /// <param name="green">Green.</param>
    /// <param name="blue">Blue.</param>
    void Read<F, I>(I texel, out F red, out F green, out F blue)
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I>;

    /// <summary>Linear colours of texels and of their right neighbours in the store, which must lie inside it.</summary>
    /// <param name="texel">Element numbers of the left texels, in memory.</param>
    /// <param name="red0">Red on the left.</param>
    /// <param name="green0">Green on the left.</param>
    /// <param name="blue0">Blue on the left.</param>
    /// <param name="red1">Red on the right.</param>
    /// <param name="green1">Green on the right.</param>
    /// <param name="blue1">Blue on the right.</param>
    unsafe void ReadPair<F, I>(I* texel, out F red0, out F green0, out F blue0, out F red1, out F green1, out F blue1)
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I>;
}
