namespace LabRaytracer;

/// <summary>How a texture is baked to a picture.</summary>
/// <remarks>Immutable, thread safe.</remarks>
public sealed class BakeOptions
{
    private readonly int _errorGrid = 4;

    /// <summary>
    /// The surface that texture space is spread over, for 3D textures: the local point and normal at (u, v). Null (default): the texture gets (u, v, 0) as its point.
    /// </summary>
    /// <remarks><see cref="BakeSurfaces"/> has those of the built-in mappings.</remarks>
    public Func<TextureCoordinate, SurfacePosition>? Surface { get; init; }

    /// <summary>The error is measured at n x n places in every texel, [0, 16]; 0: not measured. Default: 4.</summary>
    /// <exception cref="ArgumentOutOfRangeException">Outside [0, 16].</exception>
    public int ErrorGrid
    {
        get => _errorGrid;
        init => _errorGrid = value is >= 0 and <= 16 ? value : throw new ArgumentOutOfRangeException(nameof(value), value, "The grid of a bake's error must be in [0, 16].");
    }
}
