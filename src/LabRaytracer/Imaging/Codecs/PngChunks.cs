using System.Buffers.Binary;
using System.Text;

namespace LabRaytracer;

/// <summary>The chunks of a PNG file one after the other, with their checksums verified.</summary>
internal sealed class PngChunks(Stream stream, string name)
{
    private readonly byte[] word = new byte[8];
    private uint crc;

    /// <summary>Type of the current chunk, four ASCII letters.</summary>
    public string Type { get; private set; } = string.Empty;

    /// <summary>Bytes of the current chunk that are not read yet.</summary>
    public int Remaining { get; private set; }

    /// <summary>Whether a reader may not skip the current chunk.</summary>
    public bool IsCritical => char.IsAsciiLetterUpper(Type[0]);

    /// <summary>Goes to the next chunk; the current one must have been finished.</summary>
    public void Next()
    {
        ReadRaw(word);
        uint length = BinaryPrimitives.ReadUInt32BigEndian(word);
        Type = Encoding.Latin1.GetString(word, 4, 4);
        if (length > int.MaxValue || !Type.All(char.IsAsciiLetter))
        {
            throw Bad("what should be a chunk is none");
        }

        Remaining = (int)length;
        crc = Crc32.Append(0, word.AsSpan(4, 4));
    }

    /// <summary>Some of the rest of the chunk; 0 at its end.</summary>
    public int Read(Span<byte> target)
    {
        int wanted = Math.Min(target.Length, Remaining);
        if (wanted == 0)
        {
            return 0;
        }

        int count = stream.Read(target[..wanted]);
        if (count == 0)
        {
            throw Short();
        }

        crc = Crc32.Append(crc, target[..count]);
        Remaining -= count;
        return count;
    }

    /// <summary>Skips what is left of the chunk and verifies its checksum.</summary>
    public void Finish()
    {
        Span<byte> rest = stackalloc byte[1024];
        while (Read(rest) > 0)
        {
            // The checksum covers skipped bytes too.
        }

        ReadRaw(word.AsSpan(0, 4));
        if (BinaryPrimitives.ReadUInt32BigEndian(word) != crc)
        {
            throw Bad($"the checksum (CRC) of chunk {Type} is wrong: the file is damaged");
        }
    }

    /// <summary>Takes the whole content of the chunk and verifies its checksum.</summary>
    public byte[] ReadAll(int maxBytes)
    {
        if (Remaining > maxBytes)
        {
            throw Bad($"chunk {Type} has {Remaining} bytes, over the limit of {maxBytes} (PictureLimits.MaxChunkBytes)");
        }

        // Grown as bytes arrive: a length is only a claim.
        MemoryStream content = new(Math.Min(Remaining, 1 << 12));
        Span<byte> part = stackalloc byte[1024];
        for (int count = Read(part); count > 0; count = Read(part))
        {
            content.Write(part[..count]);
        }

        Finish();
        return content.ToArray();
    }

    /// <summary>The exception for a damaged file.</summary>
    public PictureFormatException Bad(string reason) => new(name, reason);

    private PictureFormatException Short() => Bad("the file ends too early");

    private void ReadRaw(Span<byte> target)
    {
        if (stream.ReadAtLeast(target, target.Length, throwOnEndOfStream: false) < target.Length)
        {
            throw Short();
        }
    }
}
