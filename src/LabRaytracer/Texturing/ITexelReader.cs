namespace LabRaytracer;

/// <summary>Reads packed texels of one format as linear colour.</summary>
internal interface ITexelReader
{
    /// <summary>Linear colours of texels.</summary>
    /// <param name="texel">Element numbers of the texels in the store.</param>
    /// <param name="red">Red, linear.</param>
    /// <param name="green">Green, linear.</param>
    /// <param name="blue">Blue, linear.</param>
    void Read<F, I>(I texel, out F red, out F green, out F blue)
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I>;
}
