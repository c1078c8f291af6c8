namespace LabRaytracer;

/// <summary>Turns points of the picture into rays (Polish: kamera).</summary>
/// <remarks>
/// Derive from this class to add a camera of your own: <see cref="RayAt(double, double, int, int)"/> for one point in doubles is enough. World space is right-handed, +Y up.
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

    /// <summary>Tells whether the camera has a lens: then each sample has its own place on it. Default: no.</summary>
    public virtual bool HasLens => false;

    /// <summary>The ray through a point of the picture and a point of the lens. Default: the lens has only one.</summary>
    /// <param name="x">Horizontal position on the picture, pixels from the left edge, [0, width].</param>
    /// <param name="y">Vertical position on the picture, pixels from the top edge, [0, height].</param>
    /// <param name="lens">Where on the lens; the samples of a pixel fill the unit square evenly.</param>
    /// <param name="width">Width of the whole picture, pixels, above 0.</param>
    /// <param name="height">Height of the whole picture, pixels, above 0.</param>
    /// <returns>A ray in world space; its direction has length 1.</returns>
    public virtual Ray RayAt(double x, double y, SquarePoint lens, int width, int height) => RayAt(x, y, width, height);

    /// <summary>How the ray changes over one pixel to the right and one down: what texture filters go by. Default: by differences of <see cref="RayAt(double, double, int, int)"/> over 1/8 of a pixel.</summary>
    /// <param name="x">Horizontal position, as for <see cref="RayAt(double, double, int, int)"/>.</param>
    /// <param name="y">Vertical position, as for <see cref="RayAt(double, double, int, int)"/>.</param>
    /// <param name="width">Width of the whole picture, pixels, above 0.</param>
    /// <param name="height">Height of the whole picture, pixels, above 0.</param>
    public virtual RayDifferential DifferentialAt(double x, double y, int width, int height)
    {
        const double Half = 1.0 / 16;
        double left = Math.Max(0, x - Half), right = Math.Min(width, x + Half), above = Math.Max(0, y - Half), below = Math.Min(height, y + Half);
        (Vector3D origin, Vector3D direction) = Slope(RayAt(left, y, width, height), RayAt(right, y, width, height), right - left);
        (Vector3D originDown, Vector3D directionDown) = Slope(RayAt(x, above, width, height), RayAt(x, below, width, height), below - above);
        return new RayDifferential(origin, direction, originDown, directionDown);
    }

    private static (Vector3D Origin, Vector3D Direction) Slope(in Ray first, in Ray second, double distance) =>
        ((second.Origin - first.Origin) / distance, (second.Direction - first.Direction) / distance);
}
