using System.Buffers.Binary;

namespace LabRaytracer;

/// <summary>JPEG files through the system's libturbojpeg, when it is installed; otherwise says how to get JPEG.</summary>
internal sealed class JpegCodec : IPictureCodec
{
    private const long MaxFileBytes = 1L << 30;

    private const string NotThere =
        "JPEG needs the system library libturbojpeg (Debian: apt install libturbojpeg0) or a build with -p:UseImageSharp=true; neither is there";

    private static readonly Lazy<TurboJpeg?> Library = new(TurboJpeg.TryLoad);

    /// <summary>Whether JPEG files can be read on this machine.</summary>
    public static bool IsAvailable => Library.Value is not null;

    /// <inheritdoc/>
    public string Name => "JPEG";

    /// <inheritdoc/>
    public IReadOnlyList<string> Extensions { get; } = [".jpg", ".jpeg"];

    /// <inheritdoc/>
    public bool CanWrite => false;

    /// <inheritdoc/>
    public bool CanRead(ReadOnlySpan<byte> header) => header is [0xFF, 0xD8, 0xFF, ..];

    /// <inheritdoc/>
    public PixelBuffer Read(Stream stream, PictureLimits limits, string name)
    {
        ArgumentNullException.ThrowIfNull(stream);
        ArgumentNullException.ThrowIfNull(limits);
        TurboJpeg library = Library.Value ?? throw new PictureFormatException(name, NotThere);
        byte[] file = ReadFile(stream, name);
        CheckFrames(file, limits, name);
        return library.Decode(file, limits, name);
    }

    /// <inheritdoc/>
    public void Write(Picture picture, Stream stream, PictureSaveOptions options) =>
        throw new NotSupportedException("JPEG files are only read; save as .png, .ppm, .pfm or .hdr.");

    private static byte[] ReadFile(Stream stream, string name)
    {
        using MemoryStream file = new();
        byte[] part = new byte[1 << 16];
        for (int count = stream.Read(part); count > 0; count = stream.Read(part))
        {
            file.Write(part, 0, count);
            if (file.Length > MaxFileBytes)
            {
                throw new PictureFormatException(name, "the file is over the limit of 1 GiB for JPEG");
            }
        }

        return file.ToArray();
    }

    /// <summary>Checks the size in the first frame header before native code sees the file (ITU-T T.81, annex B).</summary>
    private static void CheckFrames(ReadOnlySpan<byte> file, PictureLimits limits, string name)
    {
        int at = 2;
        while (at + 9 <= file.Length && file[at] == 0xFF)
        {
            byte marker = file[at + 1];
            if (marker == 0xFF)
            {
                at++;
                continue;
            }

            if (marker is >= 0xC0 and <= 0xCF and not (0xC4 or 0xC8 or 0xCC))
            {
                int height = BinaryPrimitives.ReadUInt16BigEndian(file[(at + 5)..]);
                int width = BinaryPrimitives.ReadUInt16BigEndian(file[(at + 7)..]);
                limits.Check(width, height, name);
                return;
            }

            at += 2 + BinaryPrimitives.ReadUInt16BigEndian(file[(at + 2)..]);
        }

        throw new PictureFormatException(name, "there is no frame header: the JPEG file is damaged or ends too early");
    }
}
