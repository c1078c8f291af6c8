namespace LabRaytracer;

/// <summary>Reads texels one at a time by their column and row: the scalar door of kernels that are written for packed texels.</summary>
/// <param name="texel">The linear colour of the texel (x, y), y up.</param>
/// <param name="width">Columns.</param>
/// <param name="height">Rows.</param>
internal readonly struct ScalarTexelReader(Func<int, int, Intensity> texel, int width, int height) : ITexelReader
{
    /// <summary>Element number of the bottom-left texel, as in a store.</summary>
    public int Start => (height - 1) * width;

    public void Read<F, I>(I element, out F red, out F green, out F blue)
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I>
    {
        (int row, int x) = Math.DivRem(I.Get(element, 0), width);
        Intensity color = texel(x, height - 1 - row);
        (red, green, blue) = (F.Of(color.R), F.Of(color.G), F.Of(color.B));
    }

    public unsafe void ReadPair<F, I>(I* element, out F red0, out F green0, out F blue0, out F red1, out F green1, out F blue1)
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I>
    {
        Read(*element, out red0, out green0, out blue0);
        Read(*element + I.Of(1), out red1, out green1, out blue1);
    }

    public void Prefetch(int element)
    {
        // One texel at a time leaves nothing to be asked for ahead.
    }
}
