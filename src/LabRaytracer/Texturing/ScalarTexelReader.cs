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
}
