namespace LabRaytracer;

/// <summary>Colours of heat maps.</summary>
internal static class HeatScale
{
    /// <summary>Black, blue, red, yellow, white at 0, 1/4, 1/2, 3/4, 1; between them in proportion.</summary>
    /// <param name="heat">[0, 1].</param>
    public static Intensity Color(float heat)
    {
        ReadOnlySpan<Intensity> stops = [Intensity.Black, new(0, 0, 1), new(1, 0, 0), new(1, 1, 0), Intensity.White];
        int index = Math.Min((int)(heat * 4), 3);
        return Intensity.Lerp(stops[index], stops[index + 1], (heat * 4) - index);
    }
}
