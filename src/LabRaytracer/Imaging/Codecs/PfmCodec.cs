using System.Buffers.Binary;
using System.Globalization;
using System.Runtime.InteropServices;
using System.Text;

namespace LabRaytracer;

/// <summary>PFM files: grey (Pf) or RGB (PF) linear floats, both byte orders; nothing is clamped or lost.</summary>
/// <remarks>Format: netpbm.sourceforge.net/doc/pfm.html. Writes PF, little-endian. The size of the scale is ignored, its sign is the byte order.</remarks>
public sealed class PfmCodec : IPictureCodec
{
    /// <inheritdoc/>
    public string Name => "PFM";

    /// <inheritdoc/>
    public IReadOnlyList<string> Extensions { get; } = [".pfm"];

    /// <inheritdoc/>
    public bool CanWrite => true;

    /// <inheritdoc/>
    public bool CanRead(ReadOnlySpan<byte> header) =>
        header.Length >= 3 && header[0] == 'P' && header[1] is (byte)'f' or (byte)'F' && NetpbmText.IsSpace(header[2]);

    /// <inheritdoc/>
    public PixelBuffer Read(Stream stream, PictureLimits limits, string name)
    {
        ArgumentNullException.ThrowIfNull(stream);
        ArgumentNullException.ThrowIfNull(limits);
        PictureInput input = new(stream, name);
        string kind = NetpbmText.ReadWord(input);
        return kind is "Pf" or "PF"
            ? ReadFloats(input, kind == "PF" ? 3 : 1, limits, name)
            : throw input.Bad("this is not a PFM file");
    }

    /// <inheritdoc/>
    public void Write(Picture picture, Stream stream, PictureSaveOptions options)
    {
        ArgumentNullException.ThrowIfNull(picture);
        ArgumentNullException.ThrowIfNull(stream);
        stream.Write(Encoding.ASCII.GetBytes(string.Create(CultureInfo.InvariantCulture, $"PF\n{picture.Width} {picture.Height}\n-1.0\n")));
        byte[] row = new byte[12 * picture.Width];
        for (int y = picture.Height - 1; y >= 0; y--)
        {
            ReadOnlySpan<float> floats = MemoryMarshal.Cast<Intensity, float>(picture.Row(y));
            for (int i = 0; i < floats.Length; i++)
            {
                BinaryPrimitives.WriteSingleLittleEndian(row.AsSpan(4 * i), floats[i]);
            }

            stream.Write(row);
        }
    }

    private static PixelBuffer ReadFloats(PictureInput input, int channels, PictureLimits limits, string name)
    {
        int width = NetpbmText.ReadNumber(input);
        int height = NetpbmText.ReadNumber(input);
        string scaleText = NetpbmText.ReadWord(input);
        limits.Check(width, height, name);
        if (!float.TryParse(scaleText, NumberStyles.Float, CultureInfo.InvariantCulture, out float scale) || scale == 0 || !float.IsFinite(scale))
        {
            throw input.Bad($"the scale '{scaleText}' of a PFM file must be a number other than 0; its sign tells the byte order");
        }

        byte[] bytes = new byte[4 * width * channels];
        input.ReadExactly(bytes);
        float[] samples = new float[4 * width * height];
        for (int row = 0; row < height; row++)
        {
            if (row > 0)
            {
                input.ReadExactly(bytes);
            }

            // PFM stores the bottom row first.
            Span<float> target = samples.AsSpan(4 * width * (height - 1 - row), 4 * width);
            for (int i = 0; i < target.Length; i++)
            {
                int offset = 4 * ((i / 4 * channels) + (i % 4 % channels));
                ReadOnlySpan<byte> sample = bytes.AsSpan(offset, 4);
                target[i] = i % 4 == 3
                    ? 1
                    : scale < 0 ? BinaryPrimitives.ReadSingleLittleEndian(sample) : BinaryPrimitives.ReadSingleBigEndian(sample);
            }
        }

        return PixelBuffer.FromRgbaFloat(width, height, samples, TransferFunction.Linear, "PFM is linear");
    }
}
