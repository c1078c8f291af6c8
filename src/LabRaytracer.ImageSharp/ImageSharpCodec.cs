using System.Runtime.InteropServices;
using SixLabors.ImageSharp;
using SixLabors.ImageSharp.Formats;
using SixLabors.ImageSharp.Memory;
using SixLabors.ImageSharp.PixelFormats;

namespace LabRaytracer;

/// <summary>Reads JPEG, WebP, TIFF, GIF, BMP and QOI files with SixLabors.ImageSharp; PNG stays with <see cref="PngCodec"/>.</summary>
/// <remarks>
/// Stateless, thread safe. Samples of more than 8 bits come as 16 bits. The first frame of an animation is taken; sRGB is assumed.
/// The EXIF orientation is not applied. Every exception of the package becomes a <see cref="PictureFormatException"/>.
/// </remarks>
public sealed class ImageSharpCodec : IPictureCodec
{
    private const long MaxFileBytes = 1L << 30;

    /// <inheritdoc/>
    public string Name => "JPEG, WebP, TIFF, GIF, BMP, QOI";

    /// <inheritdoc/>
    public IReadOnlyList<string> Extensions { get; } = [".jpg", ".jpeg", ".webp", ".tif", ".tiff", ".gif", ".bmp", ".qoi"];

    /// <summary>False: pictures are written by the built-in codecs.</summary>
    public bool CanWrite => false;

    /// <inheritdoc/>
    public bool CanRead(ReadOnlySpan<byte> header) =>
        header.StartsWith((ReadOnlySpan<byte>)[0xFF, 0xD8, 0xFF])
        || header.StartsWith("GIF8"u8)
        || header.StartsWith("BM"u8)
        || header.StartsWith("II*\0"u8)
        || header.StartsWith("MM\0*"u8)
        || header.StartsWith("qoif"u8)
        || (header.Length >= 12 && header.StartsWith("RIFF"u8) && header[8..12].SequenceEqual("WEBP"u8));

    /// <inheritdoc/>
    public PixelBuffer Read(Stream stream, PictureLimits limits, string name)
    {
        ArgumentNullException.ThrowIfNull(stream);
        ArgumentNullException.ThrowIfNull(limits);
        using MemoryStream file = Copy(stream, name);
        try
        {
            return Decode(file, limits, name);
        }
        catch (Exception failure) when (failure is not PictureFormatException)
        {
            // The file is in memory: whatever is thrown comes from the package, which leaks many types for damaged files.
            throw new PictureFormatException(name, failure.Message.ReplaceLineEndings(" ").TrimEnd('.', ' '), failure);
        }
    }

    /// <inheritdoc/>
    public void Write(Picture picture, Stream stream, PictureSaveOptions options) =>
        throw new NotSupportedException("This codec only reads; save as .png, .ppm, .pfm or .hdr.");

    private static PixelBuffer Decode(MemoryStream file, PictureLimits limits, string name)
    {
        DecoderOptions options = CreateOptions(limits);
        ImageInfo info = Image.Identify(options, file);
        limits.Check(info.Width, info.Height, name);
        file.Position = 0;

        // More than 32 bits a pixel cannot be 8 bits a channel.
        if (info.PixelType.BitsPerPixel > 32)
        {
            using Image<Rgba64> deep = Image.Load<Rgba64>(options, file);
            ushort[] samples16 = new ushort[4 * deep.Width * deep.Height];
            deep.CopyPixelDataTo(MemoryMarshal.Cast<ushort, Rgba64>(samples16.AsSpan()));
            return PixelBuffer.FromRgba16(deep.Width, deep.Height, samples16, TransferFunction.Srgb, "assumed");
        }

        using Image<Rgba32> image = Image.Load<Rgba32>(options, file);
        byte[] samples = new byte[4 * image.Width * image.Height];
        image.CopyPixelDataTo(MemoryMarshal.Cast<byte, Rgba32>(samples.AsSpan()));
        return PixelBuffer.FromRgba8(image.Width, image.Height, samples, TransferFunction.Srgb, "assumed");
    }

    private static DecoderOptions CreateOptions(PictureLimits limits)
    {
        // Decoders keep a few planes of floats while they work: 32 bytes a pixel, and never less than 64 MB.
        Configuration configuration = Configuration.Default.Clone();
        configuration.MemoryAllocator = MemoryAllocator.Create(new MemoryAllocatorOptions
        {
            AllocationLimitMegabytes = (int)Math.Clamp(limits.MaxPixels * 32 / (1 << 20), 64, 16384),
        });
        return new DecoderOptions { Configuration = configuration, MaxFrames = 1, SkipMetadata = true };
    }

    private static MemoryStream Copy(Stream stream, string name)
    {
        MemoryStream file = new();
        byte[] part = new byte[1 << 16];
        for (int count = stream.Read(part); count > 0; count = stream.Read(part))
        {
            file.Write(part, 0, count);
            if (file.Length > MaxFileBytes)
            {
                throw new PictureFormatException(name, "the file is over the limit of 1 GiB");
            }
        }

        file.Position = 0;
        return file;
    }
}
