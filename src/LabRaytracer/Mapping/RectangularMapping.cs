namespace LabRaytracer;

/// <summary>Mapping of a rectangle in the (x, z) plane (lab sheet IV, section 1.1.1).</summary>
public sealed class RectangularMapping : IMapping
{
    /// <inheritdoc/>
    public TextureCoordinate Map(in SurfacePosition position) => new((position.LocalPoint.Z + 1) / 2, (position.LocalPoint.X + 1) / 2);
}
