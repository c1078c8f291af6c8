namespace LabRaytracer;

/// <summary>The texels of a picture file: decoded when they are first needed, once, and arranged for how they will be read.</summary>
/// <param name="read">Decodes the file.</param>
/// <remarks>Thread safe.</remarks>
internal sealed class TexelFile(Func<PixelBuffer> read)
{
    private readonly Lazy<PixelBuffer> _decoded = new(read);
    private volatile TexelStore? _store;

    /// <summary>The texels if they have been decoded, or null.</summary>
    public TexelStore? Decoded => _store;

    /// <summary>The texels.</summary>
    /// <param name="filter">How they will be read, as far as is known; the first caller decides.</param>
    public TexelStore Texels(TextureFilter filter)
    {
        if (_store is null)
        {
            lock (_decoded)
            {
                _store ??= new TexelStore(_decoded.Value, forPairs: filter == TextureFilter.Bilinear);
            }
        }

        return _store;
    }
}
