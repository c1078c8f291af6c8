namespace LabRaytracer;

/// <summary>One mapping and uv transform of a material, evaluated once however many textures read it.</summary>
/// <param name="Mapping">The mapping.</param>
/// <param name="Transform">Transform of its coordinates.</param>
/// <param name="Around">Coordinates that run around the surface are taken within half a turn of this place, so that a picture there goes on over the seam; null: as they are.</param>
internal readonly record struct CompiledCoordinates(IMapping Mapping, UvTransform Transform, TextureCoordinate? Around = null)
{
    /// <summary>The coordinates of a picture that is there once.</summary>
    /// <param name="mapping">The mapping.</param>
    /// <param name="transform">Transform of its coordinates.</param>
    public static CompiledCoordinates OfDecal(IMapping mapping, UvTransform transform) =>
        new(mapping, transform, mapping.ClosesU || mapping.ClosesV ? transform.Center : null);
}
