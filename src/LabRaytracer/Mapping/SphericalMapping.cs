namespace LabRaytracer;

/// <summary>Mapping of a sphere (lab sheet IV, section 1.1.3).</summary>
public sealed class SphericalMapping : IMapping
{
    /// <inheritdoc/>
    public TextureWrap DefaultWrapV => TextureWrap.Clamp;

    /// <inheritdoc/>
    public TextureCoordinate Map(in SurfacePosition position)
    {
        Point3D p = position.LocalPoint;
        double u = Math.Atan2(p.X, p.Z) / (2 * Math.PI);
        return new TextureCoordinate(u < 0 ? u + 1 : u, Math.Atan2(Math.Sqrt((p.X * p.X) + (p.Z * p.Z)), -p.Y) / Math.PI);
    }
}
