namespace LabRaytracer;

/// <summary>Colour ramps of scene files.</summary>
internal static class RampFormats
{
    private static readonly Key<double> s_at = Key.Required("at", NumberFormat.Any, "Place on the ramp.");

    private static readonly Key<Intensity> s_color = Key.Required("color", Colors.Any, "The colour there, linear.");

    private static readonly ObjectFormat<StopValue> s_stop = new(
        "colorStop", "A colour at a place of a ramp.", [s_at, s_color], fields => new StopValue(new ColorStop(fields.Get(s_at), fields.Get(s_color))));

    /// <summary>The stops of a ramp.</summary>
    public static ListFormat<StopValue> Stops { get; } = new(s_stop, "stops { at, color }");

    /// <summary>A key whose ramp has a default.</summary>
    public static Key<IReadOnlyList<StopValue>> KeyOf(string description) => Key.Optional("ramp", Stops, description);

    /// <summary>The ramp of a key; the default where it was left out, null after a mistake.</summary>
    public static ColorRamp? Get(Fields fields, Key<IReadOnlyList<StopValue>> key, ColorRamp standard)
    {
        if (fields.Find(key) is not { } stops)
        {
            return standard;
        }

        if (stops.Count == 0)
        {
            fields.Fail(key, "a list of 0", "one stop or more");
            return null;
        }

        return new ColorRamp(stops.Select(stop => stop.Stop));
    }

    /// <summary>A stop as a reference, which a list of values may hold.</summary>
    /// <param name="Stop">The stop.</param>
    internal sealed record StopValue(ColorStop Stop);
}
