namespace LabRaytracer;

/// <summary>How a scene is rendered and written.</summary>
internal static class SettingsFormats
{
    private static readonly RenderOptions s_render = new();

    private static readonly Key<int> s_width = Key.Optional("width", new IntegerFormat(1, RenderOptions.MaxSide), s_render.Width, "Width of the picture, pixels.");

    private static readonly Key<int> s_height = Key.Optional("height", new IntegerFormat(1, RenderOptions.MaxSide), s_render.Height, "Height of the picture, pixels.");

    private static readonly Key<int> s_samples = Key.Optional("samples", new IntegerFormat(1, 65536), s_render.Samples, "Samples a pixel, a square number: 1, 4, 9, 16, ...");

    private static readonly Key<SamplePattern> s_pattern = Key.Optional(
        "pattern", ChoiceFormat.Of<SamplePattern>(), s_render.Pattern, "Where the samples of a pixel lie: centres of a grid, at random in its cells, or points of Sobol's sequence, scrambled.");

    private static readonly Key<PixelFilter> s_pixelFilter = Key.Optional(
        "pixelFilter", ChoiceFormat.Of<PixelFilter>(), s_render.PixelFilter, "How the light around a pixel's centre is weighted: radius 1/2, 1, or 2 pixels.");

    private static readonly Key<double> s_errorBudget = Key.Optional(
        "errorBudget",
        new NumberFormat { Min = 0, Max = 1000 },
        s_render.ErrorBudget,
        "Root mean square error, of linear light, that the picture may have: pixels take samples until it is met. 0: none, every pixel takes as many.");

    private static readonly Key<int> s_maxSamples = Key.Optional("maxSamples", new IntegerFormat(4, 65536), s_render.MaxSamples, "Most samples a pixel under an error budget.");

    private static readonly Key<int> s_edgeSamples = Key.Optional(
        "edgeSamples", new IntegerFormat(1, 65536), s_render.EdgeSamples, "Samples of the pixels that edges of objects pass through, where that is more; no effect under an error budget.");

    private static readonly Key<int> s_maxDepth = Key.Optional("maxDepth", new IntegerFormat(0, 64), s_render.MaxDepth, "Most reflections and refractions in a row.");

    private static readonly Key<int> s_seed = Key.Optional("seed", new IntegerFormat(int.MinValue, int.MaxValue), s_render.Seed, "Number that random choices derive from.");

    private static readonly Key<Precision> s_precision = Key.Optional(
        "precision", ChoiceFormat.Of<Precision>(), s_render.Precision, "Precision of geometry and mapping; single is for previews, exact computes the last digits of every hit.");

    private static readonly Key<TransferFunction> s_encoding = Key.Optional(
        "encoding", new ChoiceFormat<TransferFunction>(("srgb", TransferFunction.Srgb), ("linear", TransferFunction.Linear)), TransferFunction.Srgb, "What the codes of the written picture mean.");

    private static readonly Key<double> s_exposure = Key.Optional("exposureStops", new NumberFormat { Min = -64, Max = 64 }, 0, "Light is multiplied by 2 to this power.");

    private static readonly Key<ToneOperator> s_tone = Key.Optional(
        "toneMapping", ChoiceFormat.Of<ToneOperator>(), ToneOperator.Clamp, "How light above display white is brought into range: cut, x / (1 + x), or a fit of the filmic ACES curve.");

    private static readonly Key<int> s_bitDepth = Key.Optional("bitDepth", new IntegerFormat(8, 16), 8, "Bits a component: 8 or 16.");

    private static readonly Key<Dithering> s_dither = Key.Optional(
        "dither", ChoiceFormat.Of<Dithering>(), Dithering.None, "How smooth light is broken up where it is rounded to 8 bits, so that gradients have no bands: by an 8 x 8 pattern, or by blue noise.");

    private static readonly Key<string> s_file = Key.Optional("file", TextFormat.Instance, "Name of the written picture, without folders; the extension tells the format.");

    /// <summary>How the scene is rendered.</summary>
    public static ObjectFormat<RenderOptions> Render { get; } = new(
        "render", "How the scene is rendered.", [s_width, s_height, s_samples, s_pattern, s_pixelFilter, s_errorBudget, s_maxSamples, s_edgeSamples, s_maxDepth, s_seed, s_precision], Options);

    /// <summary>How the picture is written.</summary>
    public static ObjectFormat<SceneOutput> Output { get; } = new(
        "output", "How the picture is written.", [s_file, s_encoding, s_exposure, s_tone, s_bitDepth, s_dither], Written);

    private static RenderOptions Options(Fields fields)
    {
        int samples = fields.Get(s_samples), side = (int)Math.Sqrt(samples);
        if (side * side != samples)
        {
            fields.Fail(s_samples, $"{samples} is not a square", $"square numbers, such as {side * side}, {(side + 1) * (side + 1)}");
            return s_render;
        }

        int width = fields.Get(s_width), height = fields.Get(s_height);
        if ((long)width * height > Array.MaxLength / 4)
        {
            fields.Fail(s_height, $"a picture of {width} x {height} pixels is too large", $"at most {Array.MaxLength / 4} pixels");
            return s_render;
        }

        return new RenderOptions
        {
            Width = width,
            Height = height,
            Samples = samples,
            Pattern = fields.Get(s_pattern),
            PixelFilter = fields.Get(s_pixelFilter),
            ErrorBudget = fields.Get(s_errorBudget),
            MaxSamples = fields.Get(s_maxSamples),
            EdgeSamples = fields.Get(s_edgeSamples),
            MaxDepth = fields.Get(s_maxDepth),
            Seed = fields.Get(s_seed),
            Precision = fields.Get(s_precision),
        };
    }

    private static SceneOutput Written(Fields fields)
    {
        string? file = fields.Find(s_file);
        if (file is not null && (file.Contains('/') || SceneFolder.Refusal(file, allowOutside: false) is not null || file is "." or ".."))
        {
            fields.Fail(s_file, $"{Wording.Quote(file)} is not a plain file name", "a name without folders, such as earth.png");
        }

        if (fields.Get(s_bitDepth) is not (8 or 16))
        {
            fields.Fail(s_bitDepth, $"{fields.Get(s_bitDepth)} bits cannot be written", "8, 16");
            return SceneOutput.Default;
        }

        return new SceneOutput
        {
            FileName = file,
            Picture = new PictureSaveOptions
            {
                Encoding = fields.Get(s_encoding),
                BitDepth = fields.Get(s_bitDepth),
                Dithering = fields.Get(s_dither),
                ToneMapping = new ToneMapping { Exposure = fields.Get(s_exposure), Operator = fields.Get(s_tone) },
            },
        };
    }
}
