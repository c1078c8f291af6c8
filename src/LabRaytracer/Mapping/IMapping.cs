namespace LabRaytracer;

/// <summary>Turns a point of a surface into texture coordinates (Polish: mapowanie).</summary>
/// <remarks>
/// <para>Lab sheet IV, section 1.1: every kind of surface has its own mapping procedure.
/// Write your own by implementing <see cref="Map"/>; the renderer calls it once per hit, from several threads at once.</para>
/// <para>The built-in mappings also know how to map many points at a time; both ways give the same bits.</para>
/// </remarks>
public interface IMapping
{
    /// <summary>Wrap in u for textures that do not choose one. Default: repeat.</summary>
    TextureWrap DefaultWrapU => TextureWrap.Repeat;

    /// <summary>Wrap in v for textures that do not choose one. Default: repeat.</summary>
    TextureWrap DefaultWrapV => TextureWrap.Repeat;

    /// <summary>Tells whether u runs around the surface, so that u and u + 1 are the same place: decals that lie over the seam go on at its other side. Default: no.</summary>
    bool ClosesU => false;

    /// <summary>Tells whether v runs around the surface, so that v and v + 1 are the same place. Default: no.</summary>
    bool ClosesV => false;

    /// <summary>The space of the points that the mapping reads, and of its gradient: the object's own, or the world. Default: the object.</summary>
    TextureFrame Frame => TextureFrame.Object;

    /// <summary>Texture coordinates of a point of a surface.</summary>
    /// <param name="position">The point, in object space.</param>
    /// <returns>(u, v), v up. Finite for every finite point.</returns>
    TextureCoordinate Map(in SurfacePosition position);

    /// <summary>
    /// How fast (u, v) changes with the local point (with the world point where that is the <see cref="Frame"/>): what filters and tangents are made of.
    /// Default: by differences of <see cref="Map"/> to both sides.
    /// </summary>
    /// <param name="position">The point, in object space.</param>
    /// <returns>Finite for every finite point; the same on both sides of a seam.</returns>
    /// <remarks>
    /// The built-in mappings know theirs in closed form. The default steps 2^-17 of the largest coordinate; whole turns between both ends of a step are a seam and do not
    /// count, and where both sides disagree (an edge) the flatter one is taken. Its relative error is about 1e-10 where the mapping is smooth on the scale of 1e-5.
    /// </remarks>
    MappingGradient Gradient(in SurfacePosition position) => MappingDifferences.Gradient(this, position);
}
