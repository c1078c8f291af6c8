namespace LabRaytracer;

/// <summary>A picture of normals in tangent space: red to the right (u), green up (v), blue out of the surface.</summary>
/// <remarks>
/// <para>Channels c in [0, 1] mean 2 c - 1. The tangents of the surface come from the mapping, so that the map looks the same on any shape, transformed and mirrored;
/// B is the direction in which v grows, T is at a right angle to it on the side where u grows.</para>
/// <para>Immutable, thread safe. The texture is data: its numbers are not sRGB-decoded by default.</para>
/// </remarks>
public sealed class NormalMap
{
    /// <summary>Creates a normal map.</summary>
    /// <param name="texture">The picture.</param>
    public NormalMap(ITexture texture) => Texture = texture ?? throw new ArgumentNullException(nameof(texture));

    /// <summary>The picture.</summary>
    public ITexture Texture { get; }

    /// <summary>How the surface is mapped; null (default): as the shape suggests.</summary>
    public IMapping? Mapping { get; init; }

    /// <summary>Transform of (u, v) before the lookup; it turns the tangents as well. Default: none.</summary>
    public UvTransform Transform { get; init => field = PropertyChecks.NotNull(value); } = UvTransform.Identity;

    /// <summary>Factor of x and y of the normals, [0, 1000]: 0 is flat. Default: 1.</summary>
    /// <exception cref="ArgumentOutOfRangeException">Outside its range or NaN.</exception>
    public float Strength
    {
        get;
        init => field = value is >= 0 and <= 1000
            ? value
            : throw new ArgumentOutOfRangeException(nameof(value), value, "The strength of a normal map must be in [0, 1000].");
    } = 1;

    /// <summary>Tells whether green points down (DirectX) instead of up (OpenGL, glTF). Default: up.</summary>
    public bool FlipGreen { get; init; }

    /// <summary>Tells whether blue is computed from red and green, z = sqrt(1 - x² - y²): for maps of two channels. Default: blue is read.</summary>
    public bool RebuildZ { get; init; }
}
