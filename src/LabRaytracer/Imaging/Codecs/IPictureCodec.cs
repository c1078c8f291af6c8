namespace LabRaytracer;

/// <summary>Reads, and perhaps writes, one family of picture files.</summary>
/// <remarks>Implementations keep no state between calls and are thread safe.</remarks>
public interface IPictureCodec
{
    /// <summary>Name for people, such as "PNG".</summary>
    string Name { get; }

    /// <summary>Extensions of its files, lower case, with the dot; the first is the usual one.</summary>
    IReadOnlyList<string> Extensions { get; }

    /// <summary>Whether <see cref="Write"/> works.</summary>
    bool CanWrite { get; }

    /// <summary>Whether a file that starts like this is for this codec.</summary>
    /// <param name="header">The first 32 bytes of the file, or all if there are fewer.</param>
    bool CanRead(ReadOnlySpan<byte> header);

    /// <summary>Reads a picture.</summary>
    /// <param name="stream">The file from its first byte; need not be seekable; left open.</param>
    /// <param name="limits">What to refuse, before memory is taken for it.</param>
    /// <param name="name">The file's name, for messages.</param>
    /// <exception cref="PictureFormatException">The content is damaged, not supported or over a limit: the only exception besides those of the stream itself.</exception>
    PixelBuffer Read(Stream stream, PictureLimits limits, string name);

    /// <summary>Writes a picture.</summary>
    /// <param name="picture">The picture.</param>
    /// <param name="stream">Target; need not be seekable; left open.</param>
    /// <param name="options">How.</param>
    /// <exception cref="NotSupportedException"><see cref="CanWrite"/> is false.</exception>
    void Write(Picture picture, Stream stream, PictureSaveOptions options);
}
