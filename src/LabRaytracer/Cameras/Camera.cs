namespace LabRaytracer;

/// <summary>Turns points of the picture into rays (Polish: kamera).</summary>
/// <remarks>
/// Derive from this class to add a camera of your own: <see cref="RayAt"/> for one point in doubles is enough. World space is right-handed, +Y up.
/// Implementations must not change while rendering: the renderer calls them from several threads at once.
/// </remarks>
public abstract class Camera
{
    /// <summary>The ray through a point of the picture.</summary>
    /// <param name="x">Horizontal position on the picture, pixels from the left edge, [0, width]; a pixel's centre is at its column + 1/2.</param>
    /// <param name="y">Vertical position on the picture, pixels from the top edge, [0, height].</param>
    /// <param name="width">Width of the whole picture, pixels, above 0.</param>
    /// <param name="height">Height of the whole picture, pixels, above 0.</param>
    /// <returns>A ray in world space; its direction has length 1.</returns>
    public abstract Ray RayAt(double x, double y, int width, int height);
}
