namespace LabRaytracer;

/// <summary>Where tiles go. Thread safe; tiles must be opened in the order of their rows.</summary>
internal interface ITileTarget
{
    /// <summary>The part of the picture that a row of tiles belongs to; may wait for room.</summary>
    /// <param name="tileRow">Number of the row of tiles, from the top.</param>
    /// <returns>The part; null after <see cref="Stop"/>.</returns>
    PicturePart? Open(int tileRow);

    /// <summary>Tells that one tile of a row is finished.</summary>
    void Close(int tileRow);

    /// <summary>Lets nobody wait any longer: the picture will not be finished.</summary>
    void Stop();
}
