namespace LabRaytracer;

/// <summary>PNG files (PNG specification, third edition; ISO/IEC 15948).</summary>
/// <remarks>
/// Reads every colour type, bit depth, interlacing and tRNS; checks the checksums and the order of chunks. The meaning of the samples is
/// taken from cICP, sRGB, gAMA and iCCP's name, in this order, and otherwise assumed to be sRGB. Writes RGB of 8 or 16 bits.
/// </remarks>
public sealed class PngCodec : IPictureCodec
{
    /// <summary>The first eight bytes of a PNG file.</summary>
    internal static ReadOnlySpan<byte> Signature => [0x89, (byte)'P', (byte)'N', (byte)'G', 13, 10, 26, 10];

    /// <inheritdoc/>
    public string Name => "PNG";

    /// <inheritdoc/>
    public IReadOnlyList<string> Extensions { get; } = [".png"];

    /// <inheritdoc/>
    public bool CanWrite => true;

    /// <inheritdoc/>
    public bool CanRead(ReadOnlySpan<byte> header) => header.StartsWith(Signature);

    /// <inheritdoc/>
    public PixelBuffer Read(Stream stream, PictureLimits limits, string name)
    {
        ArgumentNullException.ThrowIfNull(stream);
        ArgumentNullException.ThrowIfNull(limits);
        Span<byte> signature = stackalloc byte[8];
        int length = stream.ReadAtLeast(signature, 8, throwOnEndOfStream: false);
        if (length < 8 || !signature.SequenceEqual(Signature))
        {
            throw new PictureFormatException(name, "this is not a PNG file: its signature is missing or damaged");
        }

        return new PngReader(stream, limits, name).Read();
    }

    /// <inheritdoc/>
    public void Write(Picture picture, Stream stream, PictureSaveOptions options)
    {
        ArgumentNullException.ThrowIfNull(picture);
        ArgumentNullException.ThrowIfNull(stream);
        ArgumentNullException.ThrowIfNull(options);
        PngRowWriter writer = new(stream, picture.Width, picture.Height, options);
        writer.WriteRows(picture.Memory);
        writer.Finish();
    }
}
