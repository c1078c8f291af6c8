using System.CommandLine;
using System.Globalization;
using LabRaytracer;

namespace RenderScene;

/// <summary>The options that change how a picture is written.</summary>
internal sealed class OutputSettings
{
    private static readonly Dictionary<string, ToneOperator> s_operators = Enum.GetValues<ToneOperator>().ToDictionary(value => Word(value.ToString()));

    private static readonly Dictionary<string, Dithering> s_ditherings = Enum.GetValues<Dithering>().ToDictionary(value => Word(value.ToString()));

    private readonly Option<string?> _exposure = new("--exposure") { HelpName = "STOPS", Description = "Light is multiplied by 2 to this power, -64 to 64, before tone mapping." };

    private readonly Option<string?> _toneMapping = new("--tone-mapping")
    {
        HelpName = string.Join('|', s_operators.Keys), Description = "How light above display white is brought into range: cut, x / (1 + x), or a filmic curve.",
    };

    private readonly Option<string?> _dither = new("--dither")
    {
        HelpName = string.Join('|', s_ditherings.Keys), Description = "How smooth light is broken up where it is rounded to 8 bits: not at all, in a pattern of 8 x 8 pixels, without a pattern.",
    };

    /// <summary>All of them, to add to a command.</summary>
    public IEnumerable<Option> All => [_exposure, _toneMapping, _dither];

    /// <summary>What a scene asks for with the options of the command line in their place.</summary>
    /// <param name="parsed">The command line.</param>
    /// <param name="scene">What the scene asks for.</param>
    /// <exception cref="UsageException">A value is not allowed.</exception>
    public PictureSaveOptions Apply(ParseResult parsed, PictureSaveOptions scene)
    {
        string? exposure = parsed.GetValue(_exposure), toneMapping = parsed.GetValue(_toneMapping), dither = parsed.GetValue(_dither);
        return new PictureSaveOptions
        {
            Encoding = scene.Encoding,
            BitDepth = scene.BitDepth,
            PngCompression = scene.PngCompression,
            Text = scene.Text,
            ToneMapping = new ToneMapping
            {
                Exposure = exposure is null ? scene.ToneMapping.Exposure : OptionText.Number("--exposure", exposure, -64, 64),
                Operator = toneMapping is null ? scene.ToneMapping.Operator : OptionText.Word("--tone-mapping", toneMapping, s_operators),
            },
            Dithering = dither is null ? scene.Dithering : OptionText.Word("--dither", dither, s_ditherings),
        };
    }

    /// <summary>Options in the words of the command line, those that are not the usual ones.</summary>
    public static string Describe(PictureSaveOptions options)
    {
        string text = options.ToneMapping.Exposure == 0 ? "" : string.Create(CultureInfo.InvariantCulture, $" --exposure {options.ToneMapping.Exposure}");
        text += options.ToneMapping.Operator == ToneOperator.Clamp ? "" : $" --tone-mapping {Word(options.ToneMapping.Operator.ToString())}";
        return text + (options.Dithering == Dithering.None ? "" : $" --dither {Word(options.Dithering.ToString())}");
    }

    private static string Word(string name) => name.ToLowerInvariant();
}
