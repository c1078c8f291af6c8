namespace LabRaytracer;

/// <summary>A picture as a texture (Polish: tekstura): the class of lab sheet IV, Program 1.</summary>
/// <remarks>Placeholder members follow.</remarks>
public sealed class Texture : ITexture
{
    private readonly Intensity[,] _colorMap;

    /// <summary>Creates a black texture.</summary>
    /// <param name="width">Columns, [1, 1048576].</param>
    /// <param name="height">Rows, [1, 1048576].</param>
    public Texture(int width, int height)
    {
        ArgumentOutOfRangeException.ThrowIfNegativeOrZero(width);
        ArgumentOutOfRangeException.ThrowIfNegativeOrZero(height);
        _colorMap = new Intensity[width, height];
    }

    /// <summary>Number of columns.</summary>
    public int Width => _colorMap.GetLength(0);

    /// <summary>Number of rows.</summary>
    public int Height => _colorMap.GetLength(1);

    /// <summary>Colours of the texels: [x, y], x to the right, y up; [0, 0] is the bottom-left texel.</summary>
    public Intensity[,] ColorMap => _colorMap;

    /// <summary>How the texture is looked up. Default: bilinear.</summary>
    public SamplingOptions Sampling { get; set; } = SamplingOptions.Default;

    /// <inheritdoc/>
    public Intensity Sample(in TextureLookup lookup) => _colorMap[0, 0];
}
