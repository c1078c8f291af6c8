namespace LabRaytracer;

/// <summary>How a picture is written. Formats take what they know: float formats (PFM, HDR) ignore everything but <see cref="Text"/>.</summary>
/// <remarks>Immutable, thread safe.</remarks>
public sealed class PictureSaveOptions
{
    private readonly int bitDepth = 8;
    private readonly ToneMapping toneMapping = ToneMapping.Default;
    private readonly IReadOnlyList<KeyValuePair<string, string>> text = [];

    /// <summary>8 bits, sRGB, clamped, default compression.</summary>
    public static PictureSaveOptions Default { get; } = new();

    /// <summary>What the stored codes mean; default <see cref="TransferFunction.Srgb"/>. Netpbm files are always sRGB.</summary>
    public TransferFunction Encoding { get; init; } = TransferFunction.Srgb;

    /// <summary>Bits a component, 8 or 16; default 8.</summary>
    /// <exception cref="ArgumentOutOfRangeException">The value is neither 8 nor 16.</exception>
    public int BitDepth
    {
        get => bitDepth;
        init => bitDepth = value is 8 or 16
            ? value
            : throw new ArgumentOutOfRangeException(nameof(value), value, "The bit depth of a saved picture must be 8 or 16.");
    }

    /// <summary>How light is brought into [0, 1]; default <see cref="ToneMapping.Default"/>.</summary>
    /// <exception cref="ArgumentNullException">The value is null.</exception>
    public ToneMapping ToneMapping
    {
        get => toneMapping;
        init => toneMapping = value ?? throw new ArgumentNullException(nameof(value));
    }

    /// <summary>Whether smooth light is broken up where it is rounded to codes of 8 bits; default <see cref="Dithering.None"/>. Codes of 16 bits never are.</summary>
    /// <exception cref="ArgumentOutOfRangeException">The value is not one of the enumeration.</exception>
    public Dithering Dithering { get; init => field = PropertyChecks.Known(value); } = Dithering.None;

    /// <summary>Time against size of PNG files; default <see cref="PngCompression.Default"/>.</summary>
    public PngCompression PngCompression { get; init => field = PropertyChecks.Known(value); } = PngCompression.Default;

    /// <summary>Keys and values to keep in the file (PNG text chunks); keys of 1..79 printable ASCII characters; default none.</summary>
    /// <exception cref="ArgumentNullException">The list is null.</exception>
    /// <exception cref="ArgumentException">A key is empty, too long or has other characters, or a value holds a NUL character.</exception>
    public IReadOnlyList<KeyValuePair<string, string>> Text
    {
        get => text;
        init
        {
            ArgumentNullException.ThrowIfNull(value);
            foreach ((string key, string content) in value)
            {
                CheckText(key, content);
            }

            text = [.. value];
        }
    }

    private static void CheckText(string key, string content)
    {
        bool good = key is { Length: >= 1 and <= 79 } && key.Trim() == key && !key.Contains("  ", StringComparison.Ordinal);
        foreach (char c in key ?? string.Empty)
        {
            good &= c is >= ' ' and <= '~';
        }

        if (!good)
        {
            throw new ArgumentException(
                $"'{key}' cannot be the key of a text in a picture: 1..79 ASCII characters are allowed, with single spaces inside only.",
                nameof(key));
        }

        if (content is null || content.Contains('\0'))
        {
            throw new ArgumentException($"The text '{key}' of a picture must not be null or hold a NUL character.", nameof(content));
        }
    }
}
