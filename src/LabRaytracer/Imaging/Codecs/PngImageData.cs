namespace LabRaytracer;

/// <summary>The contents of consecutive IDAT chunks as one stream; at its end the chunks stand at the first other chunk.</summary>
internal sealed class PngImageData(PngChunks chunks) : Stream
{
    /// <summary>Whether reading the file itself has failed, so that an I/O error is not a damaged picture.</summary>
    public bool SourceFailed { get; private set; }

    /// <inheritdoc/>
    public override bool CanRead => true;

    /// <inheritdoc/>
    public override bool CanSeek => false;

    /// <inheritdoc/>
    public override bool CanWrite => false;

    /// <inheritdoc/>
    public override long Length => throw new NotSupportedException("The length of this stream is not known.");

    /// <inheritdoc/>
    public override long Position
    {
        get => throw new NotSupportedException("This stream has no position.");
        set => throw new NotSupportedException("This stream has no position.");
    }

    /// <inheritdoc/>
    public override int Read(Span<byte> buffer)
    {
        try
        {
            return ReadChunks(buffer);
        }
        catch (IOException)
        {
            SourceFailed = true;
            throw;
        }
    }

    /// <inheritdoc/>
    public override int Read(byte[] buffer, int offset, int count) => Read(buffer.AsSpan(offset, count));

    /// <inheritdoc/>
    public override void Flush()
    {
    }

    /// <inheritdoc/>
    public override long Seek(long offset, SeekOrigin origin) => throw new NotSupportedException("This stream cannot seek.");

    /// <inheritdoc/>
    public override void SetLength(long value) => throw new NotSupportedException("This stream is for reading.");

    /// <inheritdoc/>
    public override void Write(byte[] buffer, int offset, int count) => throw new NotSupportedException("This stream is for reading.");

    private int ReadChunks(Span<byte> buffer)
    {
        while (chunks.Type == "IDAT")
        {
            int count = chunks.Read(buffer);
            if (count > 0 || buffer.IsEmpty)
            {
                return count;
            }

            chunks.Finish();
            chunks.Next();
        }

        return 0;
    }
}
