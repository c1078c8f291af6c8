namespace LabRaytracer;

/// <summary>A local lighting model (Polish: model oświetlenia): how a point reflects the light of one lamp towards the viewer.</summary>
/// <remarks>
/// Write your own by implementing <see cref="Reflect"/>; the renderer finds lamps, shadows and textures and sums up, and calls it from several threads at once.
/// </remarks>
public interface IShader
{
    /// <summary>Tells whether the model uses <see cref="SurfaceValues.Specular"/> and <see cref="SurfaceValues.Shininess"/>. Default: yes.</summary>
    bool UsesSpecular => true;

    /// <summary>The share of one lamp's light that goes to the viewer, cosine included.</summary>
    /// <param name="values">Coefficients at the point.</param>
    /// <param name="normal">Shading normal on the viewer's side, length 1, world space.</param>
    /// <param name="toLight">Direction to the lamp, length 1, world space; above the surface (normal . toLight &gt; 0).</param>
    /// <param name="toViewer">Direction to the viewer, length 1, world space.</param>
    /// <returns>Factor for the lamp's intensity, per channel, at least 0.</returns>
    Intensity Reflect(in SurfaceValues values, Vector3D normal, Vector3D toLight, Vector3D toViewer);
}
