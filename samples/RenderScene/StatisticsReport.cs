using System.Globalization;
using System.Text.Json;
using LabRaytracer;

namespace RenderScene;

/// <summary>What a render did, as text and as JSON.</summary>
internal sealed class StatisticsReport(string scene, string output, RenderOptions options, RenderStatistics statistics)
{
    /// <summary>Wall time of reading the scene file, seconds.</summary>
    public double LoadSeconds { get; init; }

    /// <summary>Wall time from reading to the written picture, seconds.</summary>
    public double TotalSeconds { get; init; }

    /// <summary>The pictures that were decoded.</summary>
    public IReadOnlyList<PictureReport> Pictures { get; init; } = [];

    /// <summary>Where pixels take different numbers of samples the mean number.</summary>
    private string Samples => statistics.EstimatedRmse is null && statistics.EdgePixels == 0
        ? string.Create(CultureInfo.InvariantCulture, $"{options.Samples} samples a pixel")
        : string.Create(CultureInfo.InvariantCulture, $"{MeanSamples:0.00} samples a pixel on average");

    private double MeanSamples
    {
        get
        {
            PixelRectangle area = Renderer.Area(options);
            return (double)statistics.PrimaryRays / ((long)area.Width * area.Height);
        }
    }

    private IReadOnlyList<(string Key, string Words, double Value)> Times =>
    [
        ("loadSeconds", "scene file read", LoadSeconds),
        ("prepareSeconds", "scene made ready", statistics.PrepareSeconds),
        ("renderSeconds", "rendered", statistics.RenderSeconds),
        ("totalSeconds", "in all, with writing", TotalSeconds),
    ];

    private IReadOnlyList<(string Key, string Words, long Value)> Counts =>
    [
        ("primaryRays", "rays from the camera", statistics.PrimaryRays),
        ("edgePixels", "  pixels at edges of objects", statistics.EdgePixels),
        ("secondaryRays", "reflected and refracted rays", statistics.SecondaryRays),
        ("secondaryRaysSkipped", "  skipped: too faint to be seen", statistics.SecondaryRaysSkipped),
        ("hits", "visible hits", statistics.Hits),
        ("hitsRefined", "  refined: twice the digits", statistics.HitsRefined),
        ("lampSamples", "samples of lamps of some extent", statistics.LampSamples),
        ("shadowRays", "shadow rays", statistics.ShadowRays),
        ("shadowRaysSkipped", "  skipped: no light from there", statistics.ShadowRaysSkipped),
        ("mappings", "mappings evaluated", statistics.Mappings),
        ("textureLookups", "texture lookups", statistics.TextureLookups),
        ("filterFallbacks", "  filtered too softly: too long", statistics.FilterFallbacks),
        ("alphaTests", "opacities looked up", statistics.AlphaTests),
        ("constantSlots", "  skipped: constant coefficients", statistics.ConstantSlots),
        ("textures", "textures made ready", statistics.Textures),
        ("geometryBytes", "bytes of geometry", statistics.GeometryBytes),
        ("laneWidth", "floats computed at once", statistics.LaneWidth),
        ("notFinitePixels", "pixels that were not finite", statistics.NotFinitePixels),
    ];

    /// <summary>Says where colours were not finite, if any were.</summary>
    public static void WarnOfNotFinite(RenderStatistics statistics, TextWriter error)
    {
        if (statistics.NotFinitePixels > 0)
        {
            (int x, int y) = statistics.FirstNotFinitePixel ?? default;
            error.WriteLine(string.Create(
                CultureInfo.InvariantCulture, $"warning: {statistics.NotFinitePixels} pixels were not finite and are black, the first at ({x}, {y}); --view nan shows them."));
        }
    }

    /// <summary>One line for people.</summary>
    public void WriteLine(TextWriter writer)
    {
        PixelRectangle area = Renderer.Area(options);
        writer.WriteLine(string.Create(CultureInfo.InvariantCulture, $"{output}: {area.Width} x {area.Height} pixels in {TotalSeconds:0.00} s"));
    }

    /// <summary>A table for people.</summary>
    public void WriteText(TextWriter writer)
    {
        writer.WriteLine(string.Create(CultureInfo.InvariantCulture, $"{output}: {options.Width} x {options.Height} pixels, {Samples}, {options.Threads} threads"));
        if (statistics.EstimatedRmse is { } rmse)
        {
            string rest = rmse > options.ErrorBudget ? $", not met with {options.MaxSamples} samples at most; --max-samples allows more" : "";
            writer.WriteLine(string.Create(CultureInfo.InvariantCulture, $"  {"estimated RMSE, linear light",-34} {rmse,14:0.000000} of {options.ErrorBudget}{rest}"));
        }

        foreach ((_, string words, double value) in Times)
        {
            writer.WriteLine(string.Create(CultureInfo.InvariantCulture, $"  {words,-34} {value,14:0.000} s"));
        }

        foreach ((_, string words, long value) in Counts)
        {
            writer.WriteLine(string.Create(CultureInfo.InvariantCulture, $"  {words,-34} {value,14:#,0}"));
        }

        foreach (PictureReport picture in Pictures)
        {
            writer.WriteLine(picture.Text);
        }

        WriteSkipped(writer);
        foreach ((string stage, double seconds) in statistics.StageSeconds)
        {
            writer.WriteLine(string.Create(CultureInfo.InvariantCulture, $"  {$"stage {stage}, all threads",-34} {seconds,14:0.000} s"));
        }
    }

    private void WriteSkipped(TextWriter writer)
    {
        writer.WriteLine("  left out, and what it would have cost, all threads (count x mean cost of its kind in this render)");
        foreach (SkippedWork work in statistics.Skipped)
        {
            string cost = work.Seconds is { } seconds ? string.Create(CultureInfo.InvariantCulture, $"{seconds:0.000} s") : "unknown: none was done";
            writer.WriteLine(string.Create(CultureInfo.InvariantCulture, $"    {work.Item,-48} {work.Count,14:#,0}  {cost}"));
        }
    }

    /// <summary>The same for programs.</summary>
    public void WriteJson(Stream stream)
    {
        using Utf8JsonWriter json = new(stream, new JsonWriterOptions { Indented = true, NewLine = "\n" });
        json.WriteStartObject();
        json.WriteString("scene", scene);
        json.WriteString("output", output);
        json.WriteString("version", VersionVerb.Version);
        json.WriteNumber("width", options.Width);
        json.WriteNumber("height", options.Height);
        json.WriteNumber("samples", options.Samples);
        json.WriteNumber("threads", options.Threads);
        json.WriteString("precision", RenderSettings.Word(options.Precision));
        if (statistics.EstimatedRmse is { } rmse)
        {
            json.WriteNumber("errorBudget", options.ErrorBudget);
            json.WriteNumber("maxSamples", options.MaxSamples);
            json.WriteNumber("meanSamples", MeanSamples);
            json.WriteNumber("estimatedRmse", rmse);
        }

        foreach ((string key, _, double value) in Times)
        {
            json.WriteNumber(key, value);
        }

        foreach ((string key, _, long value) in Counts)
        {
            json.WriteNumber(key, value);
        }

        json.WriteStartArray("pictures");
        foreach (PictureReport picture in Pictures)
        {
            picture.WriteJson(json);
        }

        json.WriteEndArray();
        json.WriteStartArray("skipped");
        foreach (SkippedWork work in statistics.Skipped)
        {
            json.WriteStartObject();
            json.WriteString("item", work.Item);
            json.WriteNumber("count", work.Count);
            if (work.Seconds is { } seconds)
            {
                json.WriteNumber("seconds", seconds);
            }

            json.WriteEndObject();
        }

        json.WriteEndArray();
        json.WriteStartObject("stageSeconds");
        foreach ((string stage, double seconds) in statistics.StageSeconds)
        {
            json.WriteNumber(stage, seconds);
        }

        json.WriteEndObject();
        json.WriteEndObject();
    }
}
