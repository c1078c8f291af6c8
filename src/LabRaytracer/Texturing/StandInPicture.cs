namespace LabRaytracer;

/// <summary>The picture that stands in for one that is missing or damaged: a checker of magenta and black that nobody takes for the real one.</summary>
internal static class StandInPicture
{
    private const int Side = 64, Cell = 8;

    /// <summary>The texels of a file, or the stand-in's.</summary>
    /// <param name="path">The file.</param>
    /// <param name="limits">Limits of size; null for the defaults.</param>
    /// <param name="failed">Told what is wrong with the file.</param>
    public static PixelBuffer Read(string path, PictureLimits? limits, Action<Exception> failed)
    {
        try
        {
            return PictureCodecs.Default.Read(path, limits);
        }
        catch (Exception failure) when (failure is PictureFormatException or IOException or UnauthorizedAccessException)
        {
            failed(failure);
            return Create();
        }
    }

    /// <summary>8 x 8 cells, magenta at the top left.</summary>
    public static PixelBuffer Create()
    {
        byte[] samples = new byte[4 * Side * Side];
        for (int i = 0; i < Side * Side; i++)
        {
            byte light = (byte)((((i % Side / Cell) + (i / Side / Cell)) & 1) == 0 ? 255 : 0);
            (samples[4 * i], samples[(4 * i) + 2], samples[(4 * i) + 3]) = (light, light, 255);
        }

        return PixelBuffer.FromRgba8(Side, Side, samples, TransferFunction.Srgb, "a checker stands in");
    }
}
