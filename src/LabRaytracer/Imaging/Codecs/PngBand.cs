namespace LabRaytracer;

/// <summary>Some rows of a PNG file, compressed: deflate blocks up to a byte boundary, none of them marked as the last.</summary>
/// <param name="Compressed">The blocks.</param>
/// <param name="Adler">Checksum of the filtered rows.</param>
/// <param name="RawLength">Bytes of the filtered rows.</param>
internal readonly record struct PngBand(ReadOnlyMemory<byte> Compressed, uint Adler, int RawLength);
