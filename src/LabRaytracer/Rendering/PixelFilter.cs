namespace LabRaytracer;

/// <summary>How the light around the centre of a pixel is weighted.</summary>
/// <remarks>
/// A pixel's samples are spread as the filter weighs them and belong to this pixel alone (filter importance sampling: Ernst, Stamminger and Greiner, 2006).
/// So a pixel depends neither on tiles nor on threads. A single regular sample lies at the centre with any filter.
/// </remarks>
public enum PixelFilter
{
    /// <summary>Even over the pixel: radius 1/2 pixel. The default.</summary>
    Box,

    /// <summary>Falls in proportion to the distance along each axis: radius 1 pixel. Softer than the box, less aliasing.</summary>
    Tent,

    /// <summary>The cubic of Mitchell and Netravali with B = C = 1/3: radius 2 pixels, slightly negative from 8/7 on: sharp with little aliasing.</summary>
    Mitchell,
}
