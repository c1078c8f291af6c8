namespace LabRaytracer;

/// <summary>The formula of a lamp, written once for any width and precision.</summary>
internal interface ILightFormula
{
    /// <summary>The lamp's full intensity.</summary>
    Intensity Intensity { get; }

    /// <summary>The light that arrives at points.</summary>
    /// <param name="x">World x.</param>
    /// <param name="y">World y.</param>
    /// <param name="z">World z.</param>
    /// <param name="sample">Direction, distance and share of the intensity; all finite except the distance of directional light.</param>
    void Sample<R>(R x, R y, R z, out LightLanes<R> sample)
        where R : unmanaged, IReal<R>;
}
