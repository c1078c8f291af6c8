namespace LabRaytracer;

/// <summary>Takes a picture in bands of rows while it is being made, so that it need not be held as a whole.</summary>
internal interface IBandSink
{
    /// <summary>Rows of a band; the last one may have fewer. A multiple of <see cref="PngRowWriter.RowStep"/>.</summary>
    int BandRows { get; }

    /// <summary>Works on a finished band, on the thread that finished it; several bands at once, in any order.</summary>
    /// <param name="rows">Its pixels; they may change after the call.</param>
    /// <returns>What is left to be done; called once, after that of the band above.</returns>
    Action Prepare(ReadOnlySpan<Intensity> rows);
}
