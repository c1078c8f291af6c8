namespace LabRaytracer;

/// <summary>A picture that is held as a whole.</summary>
/// <param name="picture">The picture.</param>
/// <param name="top">Row of the whole picture that is its row 0.</param>
internal sealed class WholeTarget(Picture picture, int top) : ITileTarget
{
    /// <inheritdoc/>
    public PicturePart? Open(int tileRow) => new PicturePart(picture, top);

    /// <inheritdoc/>
    public void Close(int tileRow)
    {
    }

    /// <inheritdoc/>
    public void Stop()
    {
    }
}
