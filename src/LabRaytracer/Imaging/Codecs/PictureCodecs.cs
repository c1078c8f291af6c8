using System.Collections.Immutable;

namespace LabRaytracer;

/// <summary>The picture formats in use: which codec reads a file is decided by its content, which one writes by the extension.</summary>
/// <remarks>Immutable, thread safe. Earlier codecs win.</remarks>
public sealed class PictureCodecs
{
    private const int HeaderBytes = 32;
    private const string AdapterType = "LabRaytracer.ImageSharpCodec, LabRaytracer.ImageSharp";

    private PictureCodecs(ImmutableArray<IPictureCodec> codecs) => Codecs = codecs;

    /// <summary>The built-in codecs and, when its assembly lies beside the program, the ImageSharp adapter.</summary>
    public static PictureCodecs Default { get; } = new(CreateDefault());

    /// <summary>The codecs, in the order in which they are asked.</summary>
    public ImmutableArray<IPictureCodec> Codecs { get; }

    /// <summary>A registry that asks this codec before the others.</summary>
    /// <param name="codec">The codec to add.</param>
    public PictureCodecs With(IPictureCodec codec)
    {
        ArgumentNullException.ThrowIfNull(codec);
        return new PictureCodecs(Codecs.Insert(0, codec));
    }

    /// <summary>Reads a picture file.</summary>
    /// <param name="path">The file; its extension does not matter.</param>
    /// <param name="limits">What is refused; null for the defaults.</param>
    /// <exception cref="PictureFormatException">The content is damaged, unknown or over a limit.</exception>
    /// <exception cref="IOException">The file cannot be read.</exception>
    public PixelBuffer Read(string path, PictureLimits? limits = null)
    {
        ArgumentException.ThrowIfNullOrEmpty(path);
        using FileStream stream = new(path, FileMode.Open, FileAccess.Read, FileShare.Read, 1 << 16, FileOptions.SequentialScan);
        return Read(stream, path, limits);
    }

    /// <summary>Reads a picture from a stream.</summary>
    /// <param name="stream">The file from its first byte; need not be seekable; left open.</param>
    /// <param name="name">The file's name, for messages.</param>
    /// <param name="limits">What is refused; null for the defaults.</param>
    /// <exception cref="PictureFormatException">The content is damaged, unknown or over a limit.</exception>
    public PixelBuffer Read(Stream stream, string name, PictureLimits? limits = null)
    {
        ArgumentNullException.ThrowIfNull(stream);
        ArgumentNullException.ThrowIfNull(name);
        byte[] header = new byte[HeaderBytes];
        int length = stream.ReadAtLeast(header, HeaderBytes, throwOnEndOfStream: false);
        foreach (IPictureCodec codec in Codecs)
        {
            if (codec.CanRead(header.AsSpan(0, length)))
            {
                using PrefixedStream whole = new(header.AsMemory(0, length), stream);
                return codec.Read(whole, limits ?? PictureLimits.Default, name);
            }
        }

        throw new PictureFormatException(
            name,
            length == 0 ? "the file is empty" : $"the format is not known; known are {string.Join(", ", Codecs.Select(codec => codec.Name))}");
    }

    /// <summary>Writes a picture; the extension chooses the format.</summary>
    /// <param name="picture">The picture.</param>
    /// <param name="path">Target. It is replaced only when the new file is complete; on failure the old one stays as it was.</param>
    /// <param name="options">How; null for the defaults.</param>
    /// <exception cref="ArgumentException">No codec writes files with this extension.</exception>
    /// <exception cref="IOException">The target cannot be written.</exception>
    public void Write(Picture picture, string path, PictureSaveOptions? options = null)
    {
        ArgumentNullException.ThrowIfNull(picture);
        IPictureCodec codec = FindWriter(path);
        AtomicFile.Write(path, stream => codec.Write(picture, stream, options ?? PictureSaveOptions.Default));
    }

    /// <summary>Finds out, before any work is done, whether a picture could be written here.</summary>
    /// <param name="path">Target; it is not changed.</param>
    /// <exception cref="ArgumentException">No codec writes files with this extension.</exception>
    /// <exception cref="IOException">The target cannot be written.</exception>
    public void CheckTarget(string path)
    {
        _ = FindWriter(path);
        AtomicFile.Check(path);
    }

    /// <summary>The codec that writes files with this extension.</summary>
    /// <param name="path">A file name; upper and lower case are the same.</param>
    /// <exception cref="ArgumentException">No codec writes files with this extension.</exception>
    public IPictureCodec FindWriter(string path)
    {
        ArgumentException.ThrowIfNullOrEmpty(path);
        string extension = Path.GetExtension(path).ToLowerInvariant();
        IEnumerable<IPictureCodec> writers = Codecs.Where(codec => codec.CanWrite);
        return writers.FirstOrDefault(codec => codec.Extensions.Contains(extension)) ?? throw new ArgumentException(
            $"Cannot write '{path}': no picture format has the extension '{extension}'. Allowed: {string.Join(", ", writers.SelectMany(codec => codec.Extensions))}.",
            nameof(path));
    }

    private static ImmutableArray<IPictureCodec> CreateDefault()
    {
        ImmutableArray<IPictureCodec>.Builder codecs = ImmutableArray.CreateBuilder<IPictureCodec>();
        codecs.AddRange(new PngCodec(), new NetpbmCodec(), new PfmCodec(), new HdrCodec());

        // The adapter is compiled on request only: its assembly is then empty or absent, and the type is not found.
        if (Type.GetType(AdapterType, throwOnError: false) is { } adapter && Activator.CreateInstance(adapter) is IPictureCodec codec)
        {
            codecs.Add(codec);
        }

        codecs.Add(new JpegCodec());
        return codecs.ToImmutable();
    }
}
