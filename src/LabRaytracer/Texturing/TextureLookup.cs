namespace LabRaytracer;

/// <summary>Where a texture is asked for its colour.</summary>
/// <param name="Coordinate">Texture coordinates after the slot's uv transform, v up; not yet wrapped. Meaningful if the texture needs them.</param>
/// <param name="LocalPoint">The hit in the shape's unit form, object space. Meaningful if the texture needs it.</param>
/// <param name="WrapU">Wrap in u that the mapping suggests.</param>
/// <param name="WrapV">Wrap in v that the mapping suggests.</param>
/// <remarks>Immutable, thread safe.</remarks>
public readonly record struct TextureLookup(
    TextureCoordinate Coordinate, Point3D LocalPoint = default, TextureWrap WrapU = TextureWrap.Repeat, TextureWrap WrapV = TextureWrap.Repeat)
{
    /// <summary>A lookup by (u, v) alone.</summary>
    public static TextureLookup At(double u, double v) => new(new TextureCoordinate(u, v));
}
