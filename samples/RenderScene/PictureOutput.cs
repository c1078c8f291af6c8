using System.Globalization;
using LabRaytracer;

namespace RenderScene;

/// <summary>Picture files that the program writes.</summary>
internal static class PictureOutput
{
    private const string DefaultFolder = "out";

    /// <summary>Where a picture goes if nobody says where: into the folder "out", which is made.</summary>
    public static string DefaultPath(string fileName)
    {
        MakeFolder(DefaultFolder);
        return Path.Combine(DefaultFolder, fileName);
    }

    /// <summary>Makes a folder if it is not there yet.</summary>
    /// <exception cref="InputException">It cannot be made.</exception>
    public static void MakeFolder(string folder)
    {
        try
        {
            Directory.CreateDirectory(folder);
        }
        catch (Exception failure) when (failure is IOException or UnauthorizedAccessException or NotSupportedException)
        {
            throw new InputException($"cannot make the folder '{folder}'; choose another place, or remove a file of this name.", failure);
        }
    }

    /// <summary>Finds out, before any work, whether files can be written.</summary>
    /// <param name="picture">The picture.</param>
    /// <param name="others">Other files; null is nothing.</param>
    /// <exception cref="UsageException">No picture format has the extension.</exception>
    /// <exception cref="IOException">A file cannot be written.</exception>
    public static void Check(string picture, params string?[] others)
    {
        try
        {
            PictureCodecs.Default.CheckTarget(picture);
        }
        catch (ArgumentException failure)
        {
            throw new UsageException(FirstSentences(failure.Message));
        }

        foreach (string other in others.OfType<string>())
        {
            AtomicFile.Check(other);
        }
    }

    /// <summary>Writes a picture; stopped, it leaves the old file as it was.</summary>
    public static void Save(Picture picture, string path, PictureSaveOptions options, CancellationToken stop)
    {
        stop.ThrowIfCancellationRequested();
        AtomicFile.Write(path, file =>
        {
            using StoppableStream stream = new(file, stop);
            PictureCodecs.Default.FindWriter(path).Write(picture, stream, options);
        });
    }

    /// <summary>The same options with texts that go into the file.</summary>
    public static PictureSaveOptions WithText(PictureSaveOptions options, params IReadOnlyList<KeyValuePair<string, string>> text) => new()
    {
        Encoding = options.Encoding, BitDepth = options.BitDepth, ToneMapping = options.ToneMapping, Dithering = options.Dithering, PngCompression = options.PngCompression, Text = text,
    };

    /// <summary>What a picture says about its own making: enough to make it again.</summary>
    public static IReadOnlyList<KeyValuePair<string, string>> Text(string scene, RenderOptions options, PictureSaveOptions save) =>
    [
        new("Title", Path.GetFileNameWithoutExtension(scene)),
        new("Software", $"LabRaytracer {VersionVerb.Version}"),
        new("Options", Describe(options) + OutputSettings.Describe(save)),
    ];

    /// <summary>Options in the words of the command line. Threads are left out: the picture does not depend on them.</summary>
    private static string Describe(RenderOptions options)
    {
        string text = string.Create(CultureInfo.InvariantCulture, $"--size {options.Width}x{options.Height} --samples {options.Samples}");
        text += $" --pattern {options.Pattern} --precision {RenderSettings.Word(options.Precision)} --view {options.View}".ToLowerInvariant();
        text += string.Create(CultureInfo.InvariantCulture, $" --seed {options.Seed}");
        text += options.PixelFilter == PixelFilter.Box ? "" : $" --pixel-filter {options.PixelFilter}".ToLowerInvariant();
        text += options.ErrorBudget > 0 ? string.Create(CultureInfo.InvariantCulture, $" --budget {options.ErrorBudget} --max-samples {options.MaxSamples}") : "";
        text += options.HasEdges ? string.Create(CultureInfo.InvariantCulture, $" --edge-samples {options.EdgeSamples}") : "";
        text += options.Filter is { } filter ? $" --filter {filter}".ToLowerInvariant() : "";
        return text + (options.Crop is { } crop ? string.Create(CultureInfo.InvariantCulture, $" --crop {crop.X},{crop.Y},{crop.Width},{crop.Height}") : "");
    }

    /// <summary>A message without the name of the parameter that the framework appends.</summary>
    private static string FirstSentences(string message)
    {
        int appended = message.IndexOf(" (Parameter '", StringComparison.Ordinal);
        return appended < 0 ? message : message[..appended];
    }
}
