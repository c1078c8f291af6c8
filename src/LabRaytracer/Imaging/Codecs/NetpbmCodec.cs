using System.Buffers.Binary;
using System.Globalization;
using System.Text;

namespace LabRaytracer;

/// <summary>Netpbm files: PGM and PPM (P2, P3, P5, P6; up to 16 bits), sRGB by convention here.</summary>
/// <remarks>Formats: netpbm.sourceforge.net/doc/pgm.html, ppm.html. Writes P6, 8 or 16 bits. Floats: <see cref="PfmCodec"/>.</remarks>
public sealed class NetpbmCodec : IPictureCodec
{
    private const string Convention = "convention of PGM and PPM";

    /// <inheritdoc/>
    public string Name => "PPM";

    /// <inheritdoc/>
    public IReadOnlyList<string> Extensions { get; } = [".ppm", ".pnm"];

    /// <inheritdoc/>
    public bool CanWrite => true;

    /// <inheritdoc/>
    public bool CanRead(ReadOnlySpan<byte> header) =>
        header.Length >= 3 && header[0] == 'P' && "2356".Contains((char)header[1]) && (NetpbmText.IsSpace(header[2]) || header[2] == '#');

    /// <inheritdoc/>
    public PixelBuffer Read(Stream stream, PictureLimits limits, string name)
    {
        ArgumentNullException.ThrowIfNull(stream);
        ArgumentNullException.ThrowIfNull(limits);
        PictureInput input = new(stream, name);
        if (input.ReadByte() != 'P')
        {
            throw input.Bad("this is not a Netpbm file");
        }

        char kind = (char)input.ReadByte();
        return kind is '2' or '3' or '5' or '6'
            ? ReadCodes(input, kind, limits, name)
            : throw input.Bad($"the Netpbm kind 'P{kind}' is not supported; allowed are P2, P3, P5, P6");
    }

    /// <inheritdoc/>
    public void Write(Picture picture, Stream stream, PictureSaveOptions options)
    {
        ArgumentNullException.ThrowIfNull(picture);
        ArgumentNullException.ThrowIfNull(stream);
        ArgumentNullException.ThrowIfNull(options);
        int max = options.BitDepth == 8 ? 255 : 65535;
        stream.Write(Encoding.ASCII.GetBytes(string.Create(CultureInfo.InvariantCulture, $"P6\n{picture.Width} {picture.Height}\n{max}\n")));
        RowEncoder encoder = new(TransferFunction.Srgb, options.BitDepth, options.ToneMapping, options.Dithering);
        byte[] row = new byte[encoder.BytesPerPixel * picture.Width];
        for (int y = 0; y < picture.Height; y++)
        {
            encoder.Encode(picture.Row(y), y, row);
            stream.Write(row);
        }
    }

    private static PixelBuffer ReadCodes(PictureInput input, char kind, PictureLimits limits, string name)
    {
        int width = NetpbmText.ReadNumber(input);
        int height = NetpbmText.ReadNumber(input);
        int max = NetpbmText.ReadNumber(input);
        limits.Check(width, height, name);
        if (max is < 1 or > 65535)
        {
            throw input.Bad($"the largest value {max} must be in [1, 65535]");
        }

        int channels = kind is '3' or '6' ? 3 : 1;
        ushort[] row = new ushort[width * channels];
        Action<ushort[]> readRow = kind is '2' or '3' ? target => ReadTextRow(input, target, max) : RawRowReader(input, row.Length, max);

        // The first row proves that there is data before memory for the rest is taken.
        readRow(row);
        int codes = 255 % max == 0 ? 255 : 65535;
        byte[] samples8 = codes == 255 ? new byte[4 * width * height] : [];
        ushort[] samples16 = codes == 255 ? [] : new ushort[4 * width * height];
        for (int y = 0; y < height; y++)
        {
            if (y > 0)
            {
                readRow(row);
            }

            if (codes == 255)
            {
                Expand8(row, samples8.AsSpan(4 * y * width, 4 * width), channels, max);
            }
            else
            {
                Expand16(row, samples16.AsSpan(4 * y * width, 4 * width), channels, max);
            }
        }

        return codes == 255
            ? PixelBuffer.FromRgba8(width, height, samples8, TransferFunction.Srgb, Convention)
            : PixelBuffer.FromRgba16(width, height, samples16, TransferFunction.Srgb, Convention);
    }

    private static void ReadTextRow(PictureInput input, ushort[] row, int max)
    {
        for (int i = 0; i < row.Length; i++)
        {
            row[i] = CheckSample(input, NetpbmText.ReadNumber(input), max);
        }
    }

    private static Action<ushort[]> RawRowReader(PictureInput input, int length, int max)
    {
        int width = max > 255 ? 2 : 1;
        byte[] bytes = new byte[length * width];
        return row =>
        {
            input.ReadExactly(bytes);
            for (int i = 0; i < row.Length; i++)
            {
                int value = width == 1 ? bytes[i] : BinaryPrimitives.ReadUInt16BigEndian(bytes.AsSpan(2 * i));
                row[i] = CheckSample(input, value, max);
            }
        };
    }

    private static ushort CheckSample(PictureInput input, int value, int max) =>
        value <= max ? (ushort)value : throw input.Bad($"the sample {value} is above the largest value {max}");

    private static void Expand8(ReadOnlySpan<ushort> row, Span<byte> target, int channels, int max)
    {
        int factor = 255 / max;
        for (int x = 0; 4 * x < target.Length; x++)
        {
            for (int c = 0; c < 3; c++)
            {
                target[(4 * x) + c] = (byte)(row[(x * channels) + (c % channels)] * factor);
            }

            target[(4 * x) + 3] = 255;
        }
    }

    private static void Expand16(ReadOnlySpan<ushort> row, Span<ushort> target, int channels, int max)
    {
        for (int x = 0; 4 * x < target.Length; x++)
        {
            for (int c = 0; c < 3; c++)
            {
                // Rounded to the nearest 16-bit code.
                target[(4 * x) + c] = (ushort)((((uint)row[(x * channels) + (c % channels)] * 65535) + ((uint)max / 2)) / (uint)max);
            }

            target[(4 * x) + 3] = 65535;
        }
    }
}
