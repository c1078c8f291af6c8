using System.CommandLine;
using LabRaytracer;

namespace RenderScene;

/// <summary>The options that change how a scene is rendered.</summary>
internal sealed class RenderSettings
{
    private static readonly Dictionary<string, object> s_precisions = new() { ["double"] = Precision.Double, ["float"] = Precision.Single, ["exact"] = Precision.Exact };

    private static readonly Dictionary<string, object> s_filters = Words(typeof(TextureFilter));

    private static readonly Dictionary<string, object> s_patterns = Words(typeof(SamplePattern));

    private static readonly Dictionary<string, object> s_pixelFilters = Words(typeof(PixelFilter));

    private static readonly Dictionary<string, object> s_views = Words(typeof(RenderView));

    private readonly Option<string?> _size = new("--size") { HelpName = "WxH", Description = "Size of the picture, pixels, such as 1280x720." };

    private readonly Option<string?> _samples = new("--samples") { HelpName = "N", Description = "Samples a pixel, a square: 1, 4, 9, 16, ..." };

    private readonly Option<string?> _pattern = Choice("--pattern", "Where the samples of a pixel lie", s_patterns.Keys);

    private readonly Option<string?> _pixelFilter = Choice("--pixel-filter", "How the light around a pixel's centre is weighted", s_pixelFilters.Keys);

    private readonly Option<string?> _budget = new("--budget")
    {
        HelpName = "E", Description = "Root mean square error (linear light) that the picture may have, such as 0.01: pixels take samples until it is met; 0: none.",
    };

    private readonly Option<string?> _maxSamples = new("--max-samples") { HelpName = "N", Description = "Most samples a pixel under a budget." };

    private readonly Option<string?> _edgeSamples = new("--edge-samples")
    {
        HelpName = "N", Description = "Samples of the pixels that edges of objects pass through, such as 16: smooth edges where the others take one sample.",
    };

    private readonly Option<string?> _seed = new("--seed") { HelpName = "N", Description = "Number that random choices derive from." };

    private readonly Option<string?> _threads = new("--threads") { HelpName = "N", Description = "Threads; the picture does not depend on them. Default: all processors." };

    private readonly Option<string?> _precision = Choice("--precision", "Precision of geometry; exact: the last digits of every hit", s_precisions.Keys);

    private readonly Option<string?> _filter = Choice("--filter", "Filter of all picture textures", s_filters.Keys);

    private readonly Option<string?> _crop = new("--crop") { HelpName = "X,Y,W,H", Description = "Render this part of the picture only; (0, 0) is the top left pixel." };

    private readonly Option<bool> _noSkip = new("--no-skip") { Description = "Do also what cannot change the picture: same bits, to measure what skipping saves." };

    private readonly Option<string?> _view = Choice("--view", "What the picture shows", s_views.Keys);

    /// <summary>The word of a precision.</summary>
    public static string Word(Precision precision) => s_precisions.First(word => precision.Equals(word.Value)).Key;

    /// <summary>All of them, to add to a command.</summary>
    public IEnumerable<Option> All => [_size, _samples, _budget, _maxSamples, _edgeSamples, _pattern, _pixelFilter, _seed, _threads, _precision, _filter, _crop, _noSkip, _view];

    /// <summary>The options of a scene with those of the command line in their place.</summary>
    /// <param name="parsed">The command line.</param>
    /// <param name="scene">What the scene asks for.</param>
    /// <exception cref="UsageException">A value is not allowed.</exception>
    public RenderOptions Apply(ParseResult parsed, RenderOptions scene)
    {
        int[] size = Given(parsed, _size, text => OptionText.Integers("--size", text, 'x', "WxH"), [scene.Width, scene.Height]);
        if (size.Any(side => side is < 1 or > RenderOptions.MaxSide) || (long)size[0] * size[1] > MaxPixels)
        {
            throw new UsageException($"--size {size[0]}x{size[1]} is not possible: 1 to {RenderOptions.MaxSide} pixels a side and at most {MaxPixels} in all.");
        }

        return new RenderOptions
        {
            Width = size[0],
            Height = size[1],
            // A budget given here stands in the place of the scene's number of samples.
            Samples = Given(parsed, _samples, Samples, parsed.GetValue(_budget) is null ? scene.Samples : 1),
            Pattern = Given(parsed, _pattern, text => (SamplePattern)OptionText.Word("--pattern", text, s_patterns), scene.Pattern),
            PixelFilter = Given(parsed, _pixelFilter, text => (PixelFilter)OptionText.Word("--pixel-filter", text, s_pixelFilters), scene.PixelFilter),
            ErrorBudget = Given(parsed, _budget, Budget, scene.ErrorBudget),
            MaxSamples = Given(parsed, _maxSamples, text => OptionText.Integer("--max-samples", text, 4, 65536), scene.MaxSamples),
            EdgeSamples = Given(parsed, _edgeSamples, text => OptionText.Integer("--edge-samples", text, 1, 65536), scene.EdgeSamples),
            Seed = Given(parsed, _seed, text => OptionText.Integer("--seed", text, int.MinValue, int.MaxValue), scene.Seed),
            Threads = Given(parsed, _threads, text => OptionText.Integer("--threads", text, 1, 1024), scene.Threads),
            Precision = Given(parsed, _precision, text => (Precision)OptionText.Word("--precision", text, s_precisions), scene.Precision),
            MaxDepth = scene.MaxDepth,
            Skipping = parsed.GetValue(_noSkip) ? Skipping.Off : scene.Skipping,
            Filter = Given(parsed, _filter, text => (TextureFilter?)OptionText.Word("--filter", text, s_filters), scene.Filter),
            View = Given(parsed, _view, text => (RenderView)OptionText.Word("--view", text, s_views), scene.View),
            Crop = Given(parsed, _crop, text => Crop(text, size[0], size[1]), scene.Crop),
        };
    }

    /// <summary>Most pixels of a picture that fit into one array of floats.</summary>
    private static int MaxPixels => 1 << 29;

    private static T Given<T>(ParseResult parsed, Option<string?> option, Func<string, T> read, T otherwise) =>
        parsed.GetValue(option) is { } text ? read(text) : otherwise;

    private static int Samples(string text)
    {
        int samples = OptionText.Integer("--samples", text, 1, 65536), side = (int)Math.Sqrt(samples);
        return side * side == samples
            ? samples
            : throw new UsageException($"--samples {samples} is not a square; near it are {side * side} and {(side + 1) * (side + 1)}.");
    }

    private static double Budget(string text)
    {
        double budget = OptionText.NotNegative("--budget", text);
        return budget <= 1000 ? budget : throw new UsageException($"--budget '{text}' is not possible: 0 to 1000, linear light; 0.01 is fine.");
    }

    private static PixelRectangle? Crop(string text, int width, int height)
    {
        int[] part = OptionText.Integers("--crop", text, ',', "X,Y,W,H");
        bool isInside = part[2] >= 1 && part[3] >= 1 && (long)part[0] + part[2] <= width && (long)part[1] + part[3] <= height;
        return isInside
            ? new PixelRectangle(part[0], part[1], part[2], part[3])
            : throw new UsageException($"--crop '{text}' is not inside the picture of {width}x{height} pixels, or is empty.");
    }

    private static Option<string?> Choice(string name, string description, IEnumerable<string> words)
    {
        Option<string?> option = new(name) { HelpName = string.Join('|', words), Description = description + "." };
        option.CompletionSources.Add([.. words]);
        return option;
    }

    // Not generic: the runtime would compile each generic method again for every enumeration, before any work.
    private static Dictionary<string, object> Words(Type type) =>
        Enum.GetNames(type).ToDictionary(name => name.ToLowerInvariant(), name => Enum.Parse(type, name));
}
