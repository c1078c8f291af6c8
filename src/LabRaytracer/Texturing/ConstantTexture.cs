namespace LabRaytracer;

/// <summary>The simplest texture: the same colour everywhere, independent of the point (lab sheet IV, section 1.1).</summary>
/// <param name="color">Linear colour.</param>
/// <remarks>Immutable, thread safe. It needs nothing of a hit: no mapping is evaluated for it.</remarks>
public sealed class ConstantTexture(Intensity color) : ITexture
{
    /// <summary>Linear colour.</summary>
    public Intensity Color { get; } = color;

    /// <inheritdoc/>
    public TextureNeeds Needs => TextureNeeds.None;

    /// <inheritdoc/>
    public Intensity Sample(in TextureLookup lookup) => Color;
}
