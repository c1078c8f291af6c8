using System.Globalization;
using System.Text;

namespace LabRaytracer;

/// <summary>Radiance pictures (.hdr): linear light with one shared exponent a pixel.</summary>
/// <remarks>
/// Format: the file-format pages of the Radiance reference manual (radsite.lbl.gov/radiance/refer/filefmts.pdf). Reads new and old run
/// lengths, flat pixels, all eight orientations; EXPOSURE values are divided out. Writes new run lengths, rows from the top.
/// XYZE files are refused.
/// </remarks>
public sealed class HdrCodec : IPictureCodec
{
    private const int MaxHeaderLines = 1000;
    private const int MaxLineLength = 2048;

    /// <inheritdoc/>
    public string Name => "Radiance HDR";

    /// <inheritdoc/>
    public IReadOnlyList<string> Extensions { get; } = [".hdr", ".pic"];

    /// <inheritdoc/>
    public bool CanWrite => true;

    /// <inheritdoc/>
    public bool CanRead(ReadOnlySpan<byte> header) => header.StartsWith("#?"u8);

    /// <inheritdoc/>
    public PixelBuffer Read(Stream stream, PictureLimits limits, string name)
    {
        ArgumentNullException.ThrowIfNull(stream);
        ArgumentNullException.ThrowIfNull(limits);
        PictureInput input = new(stream, name);
        double exposure = ReadHeader(input);
        HdrOrientation orientation = HdrOrientation.Parse(input, input.ReadLine(MaxLineLength), limits, name);
        byte[] line = new byte[4 * orientation.LineLength];
        HdrRunLength.ReadLine(input, line);
        float[] samples = new float[4 * orientation.Width * orientation.Height];
        for (int i = 0; i < orientation.Lines; i++)
        {
            if (i > 0)
            {
                HdrRunLength.ReadLine(input, line);
            }

            for (int j = 0; j < orientation.LineLength; j++)
            {
                Decode(line.AsSpan(4 * j, 4), 1 / exposure, samples.AsSpan(4 * orientation.PixelIndex(i, j), 4));
            }
        }

        return PixelBuffer.FromRgbaFloat(orientation.Width, orientation.Height, samples, TransferFunction.Linear, "Radiance HDR is linear");
    }

    /// <inheritdoc/>
    public void Write(Picture picture, Stream stream, PictureSaveOptions options)
    {
        ArgumentNullException.ThrowIfNull(picture);
        ArgumentNullException.ThrowIfNull(stream);
        string header = string.Create(
            CultureInfo.InvariantCulture,
            $"#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y {picture.Height} +X {picture.Width}\n");
        stream.Write(Encoding.ASCII.GetBytes(header));
        byte[] line = new byte[4 * picture.Width];
        for (int y = 0; y < picture.Height; y++)
        {
            ReadOnlySpan<Intensity> row = picture.Row(y);
            for (int x = 0; x < row.Length; x++)
            {
                Encode(row[x], line.AsSpan(4 * x, 4));
            }

            HdrRunLength.WriteLine(stream, line);
        }
    }

    /// <summary>Reads up to the empty line; returns the product of all EXPOSURE values.</summary>
    private static double ReadHeader(PictureInput input)
    {
        if (!input.ReadLine(MaxLineLength).StartsWith("#?", StringComparison.Ordinal))
        {
            throw input.Bad("this is not a Radiance picture: it does not start with #?");
        }

        double exposure = 1;
        for (int lines = 0; lines < MaxHeaderLines; lines++)
        {
            string text = input.ReadLine(MaxLineLength);
            if (text.Length == 0)
            {
                return exposure > 0 && double.IsFinite(exposure) ? exposure : throw input.Bad("the product of the EXPOSURE values is not possible");
            }

            if (text.StartsWith("FORMAT=", StringComparison.Ordinal) && text[7..].Trim() != "32-bit_rle_rgbe")
            {
                throw input.Bad($"FORMAT '{text[7..].Trim()}' is not supported; only 32-bit_rle_rgbe is");
            }

            if (text.StartsWith("EXPOSURE=", StringComparison.Ordinal))
            {
                bool good = double.TryParse(text[9..], NumberStyles.Float, CultureInfo.InvariantCulture, out double value);
                exposure *= good && value > 0 ? value : throw input.Bad($"EXPOSURE '{text[9..]}' is not a number above 0");
            }
        }

        throw input.Bad($"the header has more than {MaxHeaderLines} lines");
    }

    /// <summary>Mantissas in steps of 2^(e - 136). No half step is added (Radiance does): 0 stays 0.</summary>
    private static void Decode(ReadOnlySpan<byte> rgbe, double scale, Span<float> target)
    {
        double step = rgbe[3] == 0 ? 0 : Math.ScaleB(scale, rgbe[3] - 136);
        for (int c = 0; c < 3; c++)
        {
            target[c] = (float)Math.Min(rgbe[c] * step, float.MaxValue);
        }

        target[3] = 1;
    }

    /// <summary>The shared exponent is the smallest that keeps the largest component, rounded to the nearest step, below 256.</summary>
    private static void Encode(Intensity light, Span<byte> rgbe)
    {
        rgbe.Clear();
        ReadOnlySpan<float> components = [Finite(light.R), Finite(light.G), Finite(light.B)];
        float max = Math.Max(components[0], Math.Max(components[1], components[2]));
        if (max == 0)
        {
            return;
        }

        int exponent = Math.ILogB(max) + 1;
        if (Math.Floor(Math.ScaleB((double)max, 8 - exponent) + 0.5) > 255)
        {
            exponent++;
        }

        // The exponent is stored in one byte, 1..255: light below 2^-136 becomes 0, light above 255 * 2^119 that value.
        exponent = Math.Clamp(exponent, -127, 127);
        for (int c = 0; c < 3; c++)
        {
            rgbe[c] = (byte)Math.Min(255, Math.Floor(Math.ScaleB((double)components[c], 8 - exponent) + 0.5));
        }

        rgbe[3] = (byte)(exponent + 128);
    }

    /// <summary>The format has no negative light and no NaN: both become 0.</summary>
    private static float Finite(float value) => value > 0 ? Math.Min(value, float.MaxValue) : 0;
}
