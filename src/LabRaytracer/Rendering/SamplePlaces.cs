namespace LabRaytracer;

/// <summary>Where the samples of a picture lie: pattern, pixel filter and seed put together.</summary>
/// <param name="options">Filter, seed, number of samples.</param>
/// <param name="pattern">The pattern.</param>
internal sealed class SamplePlaces(RenderOptions options, SamplePattern pattern)
{
    private readonly PixelWarp _warp = new(options.PixelFilter);

    /// <summary>Places of the samples that every pixel takes.</summary>
    public SamplePlaces(RenderOptions options)
        : this(options, options.HasBudget ? SamplePattern.Sobol : options.Pattern)
    {
    }

    /// <summary>Whether samples lie at the same place in all pixels.</summary>
    public bool IsSame => pattern == SamplePattern.Regular;

    /// <summary>The filter.</summary>
    public PixelWarp Warp => _warp;

    /// <summary>Place of a sample along one axis, pixels from the pixel's left or top edge; outside [0, 1) if the filter is wider than the pixel.</summary>
    /// <param name="pixelX">Column in the whole picture.</param>
    /// <param name="pixelY">Row in the whole picture.</param>
    /// <param name="sample">Number of the sample.</param>
    /// <param name="axis">0 for x, 1 for y.</param>
    public double At(int pixelX, int pixelY, int sample, int axis) => _warp.Place(Axis(sample, axis).At(pixelX, pixelY));

    /// <summary>One sample along one axis, for many pixels.</summary>
    public SampleAxis Axis(int sample, int axis) => new(options, pattern, sample, axis);

    /// <summary>Its places in many pixels: <see cref="SampleAxis.Fill"/>, as the filter asks.</summary>
    public unsafe void Fill(in SampleAxis axis, ulong* pixels, ulong first, double* places, int count)
    {
        axis.Fill(pixels, first, places, count);
        for (int i = 0; i < count && !_warp.IsNone; i++)
        {
            places[i] = _warp.Place(places[i]);
        }
    }
}
